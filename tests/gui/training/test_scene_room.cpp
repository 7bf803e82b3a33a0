// SPDX-License-Identifier: GPL-3.0-or-later
// In the smallest window, at both ends of the scale, the scene keeps its size, the buttons stay, and all of
// the panel can be read although the pointer belongs to the scene.
#include "gui/training/training_bench.h"

#include "desktop/training/info_panel.h"
#include "desktop/training/side_panel.h"
#include "support/clipping.h"
#include "support/patience.h"

#include <QCheckBox>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>

using namespace chiron;
using namespace chiron::tests;

namespace {
constexpr QSize kSmallest(1280, 720);
}

class TestSceneRoom : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { qputenv("CHIRON_NO_SOUND", "1"); }
    void theSceneKeepsItsSize_data();
    void theSceneKeepsItsSize();
    void plotsGiveWayBeforeThePanelScrolls();
    void detailsAreNeverGivenUp();
};

void TestSceneRoom::theSceneKeepsItsSize_data() {
    QTest::addColumn<QString>("exercise");
    QTest::addColumn<int>("level");
    QTest::addColumn<QString>("language");
    QTest::addColumn<double>("scale");
    for (const auto& [exercise, level] : {std::pair{"sphere_apex", 1},
                                          {"urethra_insertion", 1},
                                          {"elastic_tube", 4},
                                          {"object_handling", 1},
                                          {"palpation", 1},
                                          {"palpation", 4}})
        for (const auto& [language, scale] : {std::pair{"en", 1.0}, {"el", 1.5}, {"de", 2.0}, {"el", 2.0}})
            QTest::addRow("%s %d, %s, %.0f %%", exercise, level, language, 100.0 * scale)
                << QString(QLatin1String(exercise)) << level << QString(QLatin1String(language)) << scale;
}

void TestSceneRoom::theSceneKeepsItsSize() {
    QFETCH(QString, exercise);
    QFETCH(int, level);
    QFETCH(QString, language);
    QFETCH(double, scale);
    TrainingBench bench;
    desktop::MainWindow& window = *bench.desktop.window;
    bench.desktop.settings.setLanguage(language);
    bench.desktop.settings.setScale(scale);
    window.resize(kSmallest);
    bench.desktop.context.applyAppearance();
    bench.train({{QStringLiteral("exercise"), exercise}, {QStringLiteral("level"), level}});
    QTRY_VERIFY_WITH_TIMEOUT(bench.runs() && bench.screen()->scene()->widget()->isVisible(), kPatience_ms);
    QCoreApplication::processEvents(); // the panel has its words of the running session
    QCOMPARE(window.size(), kSmallest);
    const desktop::TrainingScreen& screen = *bench.screen();
    const QWidget& scene = *bench.screen()->scene()->widget();
    const QString size = QStringLiteral("the scene has %1 x %2 of %3 x %4")
                             .arg(scene.width())
                             .arg(scene.height())
                             .arg(screen.width())
                             .arg(screen.height());
    QVERIFY2(2 * scene.width() >= screen.width(), qPrintable(size));
    QVERIFY2(5 * scene.height() >= 2 * screen.height(), qPrintable(size));
    const auto inSight = [&](const QWidget& part) {
        return part.isVisible() && window.rect().contains(QRect(part.mapTo(&window, QPoint()), part.size()));
    };
    QVERIFY(inSight(scene));
    for (const char* button : {"training.stop", "training.main", "training.end"})
        QVERIFY2(inSight(*bench.desktop.find<QPushButton>(QLatin1String(button))), button);
    // While it runs, and with the longer words of a pause and of a stop, no text stays cut. A live text may
    // need one more line than in the frame before, and the panel has its new layout an event later.
    const auto nothingIsCut = [&](const char* state) {
        QStringList cut;
        QTRY_VERIFY2_WITH_TIMEOUT((cut = clippedOn(&screen)).isEmpty(),
                                  qPrintable(QLatin1String(state) + QStringLiteral(": ") + cut.join(u'\n')),
                                  kPatience_ms);
    };
    nothingIsCut("running");
    // What does not fit beside the scene is read with keys, while the pointer stays in the scene.
    auto* page = bench.desktop.find<QScrollArea>(QStringLiteral("training.side"));
    QVERIFY(page);
    QScrollBar& bar = *page->verticalScrollBar();
    const auto* words = bench.desktop.find<QLabel>(QStringLiteral("training.side.read_on"));
    QTRY_COMPARE_WITH_TIMEOUT(words->isVisible(), bar.maximum() > 0, kPatience_ms);
    for (int presses = 0; presses < 50 && bar.value() < bar.maximum(); ++presses)
        QTest::keyClick(bench.screen(), Qt::Key_PageDown, Qt::ControlModifier);
    QCOMPARE(bar.value(), bar.maximum());
    const auto* last = bench.desktop.find<QCheckBox>(QStringLiteral("training.details"));
    QVERIFY(last && !last->visibleRegion().isEmpty());
    const double z_m = bench.state().tool[0].p_WT_m[2];
    for (int presses = 0; presses < 50 && bar.value() > 0; ++presses)
        QTest::keyClick(bench.screen(), Qt::Key_PageUp, Qt::ControlModifier);
    QCOMPARE(bar.value(), 0);
    QTest::qWait(50);
    QVERIFY(std::abs(bench.state().tool[0].p_WT_m[2] - z_m) < 1e-4); // and no tool is raised by it
    QVERIFY(!bench.state().paused);
    const auto* title = bench.desktop.find<QLabel>(QStringLiteral("training.force.title"));
    for (const auto& [key, state] : {std::pair{Qt::Key_Space, "paused"}, {Qt::Key_Escape, "stopped"}}) {
        const QString before = title->text();
        QTest::keyClick(bench.screen(), key);
        QTRY_VERIFY_WITH_TIMEOUT(title->text() != before, kPatience_ms);
        nothingIsCut(state);
    }
}

/// A panel with bars, numbers and plots that is just too low for all of it: the plot goes, the bars stay, and
/// with more room it is back.
void TestSceneRoom::plotsGiveWayBeforeThePanelScrolls() {
    const desktop::Theme theme = desktop::Theme::load(desktop::ThemeName::light, 1.0).value();
    session::LevelCues cues;
    cues.bars = cues.plots = true;
    desktop::SidePanel side(theme);
    auto* info = new desktop::InfoPanel(theme, QLocale::c(), cues, {});
    side.addInfo(info);
    const auto* bar = side.findChild<QWidget*>(QStringLiteral("training.force_bar"));
    const auto* plot = side.findChild<QWidget*>(QStringLiteral("training.force_plot"));
    const auto* page = side.findChild<QScrollArea*>(QStringLiteral("training.side"));
    QVERIFY(bar && plot && page);
    side.resize(300, 600);
    side.show();
    QCoreApplication::processEvents();
    QVERIFY(plot->isVisible() && page->verticalScrollBar()->maximum() == 0);
    const int whole_px = info->sizeHint().height();
    side.resize(300, whole_px - 10);
    QCoreApplication::processEvents();
    QVERIFY(!plot->isVisible() && bar->isVisible());
    QCOMPARE(page->verticalScrollBar()->maximum(), 0);
    side.resize(300, 600);
    QCoreApplication::processEvents();
    QVERIFY(plot->isVisible());
    cues.bars = false; // then the plot shows what nothing else does, and the panel scrolls
    desktop::SidePanel bare(theme);
    bare.addInfo(new desktop::InfoPanel(theme, QLocale::c(), cues, {}));
    bare.setFixedSize(300, 60); // less than its layout would leave it
    bare.show();
    QCoreApplication::processEvents();
    QVERIFY(bare.findChild<QWidget*>(QStringLiteral("training.force_plot"))->isVisible());
    const auto* low = bare.findChild<QScrollArea*>(QStringLiteral("training.side"));
    QVERIFY(low->verticalScrollBar()->maximum() > 0);
    bare.readOn(true);
    QVERIFY(low->verticalScrollBar()->value() > 0);
}

/// Whoever asked for all measurements has them, and scrolls.
void TestSceneRoom::detailsAreNeverGivenUp() {
    const desktop::Theme theme = desktop::Theme::load(desktop::ThemeName::light, 1.0).value();
    session::LevelCues cues;
    cues.bars = cues.plots = cues.numbers = true;
    desktop::SidePanel side(theme);
    auto* info = new desktop::InfoPanel(theme, QLocale::c(), cues, {});
    side.addInfo(info);
    info->setDetailed(true);
    side.resize(300, 150);
    side.show();
    QCoreApplication::processEvents();
    for (const char* part : {"training.force_plot", "training.speed_plot", "training.torque_bar"})
        QVERIFY2(side.findChild<QWidget*>(QLatin1String(part))->isVisible(), part);
    info->setDetailed(false);
    side.fit();
    QVERIFY(!side.findChild<QWidget*>(QStringLiteral("training.force_plot"))->isVisible());
}

QTEST_MAIN(TestSceneRoom)
#include "test_scene_room.moc"
