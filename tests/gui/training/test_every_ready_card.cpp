// SPDX-License-Identifier: GPL-3.0-or-later
// The ready card of every exercise and level: one number for each limit, and "Go" always in sight.
#include "gui/training/training_bench.h"

#include "app/exercises/object_handling/desktop/handling_grasping.h"
#include "cues/laparoscopy_cues.h"
#include "desktop/exercise_setup/gate_words.h"
#include "desktop/exercise_setup/level_facts.h"
#include "desktop/scene3d/scene_marks.h"
#include "desktop/training/grasping.h"
#include "desktop/training/ready_card.h"
#include "desktop/training/scene_feed.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"
#include "report/report_text.h"
#include "scoring/metric_catalogue.h"
#include "session/level_limits.h"
#include "support/languages.h"
#include "support/patience.h"

#include <algorithm>

using namespace chiron;
using namespace chiron::tests;

namespace {
const QLocale kEnglish(QLocale::English, QLocale::UnitedKingdom);

QString newtons(double value_N) {
    return kEnglish.toString(value_N, 'g', 3) + QStringLiteral(" N");
}

/// The metric of a pass mark, and the limit that is shown of it.
std::optional<double> shownLimit(const session::LevelLimits& limits, const std::string& metric) {
    return metric == "force_max" ? limits.force_N : limits.of(metric);
}
} // namespace

class TestEveryReadyCard : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { qputenv("CHIRON_NO_SOUND", "1"); }
    void theLimitShownIsTheOneThatCounts();
    void everyPassMarkHasItsLine();
    void aPassMarkBesideItsLimitSaysWhy();
    void theTargetHasOneName();
    void goIsAlwaysInSight_data();
    void goIsAlwaysInSight();

private:
    /// Whether the scene of this level, with a mouse, may draw a mark that the exercise explains.
    bool explainsMarks(const catalogue::ExerciseLevel& level) {
        const session::LevelCues cues = session::cuesOf(level, false);
        const std::vector<std::string> drawn =
            scene3d::marksOf({desktop::sceneSetupOf(level, cues, m_bench.desktop.context.theme(), false),
                              cues.coverage, level.feedback});
        const auto& legend = m_bench.desktop.site.catalogue().find(level.exercise)->legend;
        return std::any_of(legend.begin(), legend.end(), [&](const catalogue::LegendLine& line) {
            return std::find(drawn.begin(), drawn.end(), line.mark) != drawn.end();
        });
    }
    template <class Look> void everyLevel(Look look) {
        for (const catalogue::Exercise& exercise : m_bench.desktop.site.catalogue().exercises())
            for (const catalogue::ExerciseLevel& level : exercise.levels)
                look(level, QString::fromStdString(exercise.id + " " + level.id));
    }

    TrainingBench m_bench;
};

void TestEveryReadyCard::theLimitShownIsTheOneThatCounts() {
    int gates = 0, others = 0;
    everyLevel([&](const catalogue::ExerciseLevel& level, const QString& name) {
        const session::LevelLimits limits = session::levelLimits(level);
        const QString card = desktop::limitsInWords(level, kEnglish).join(QLatin1Char('\n'));
        QVERIFY2(card.contains(newtons(limits.force_N)), qPrintable(name + QLatin1Char('\n') + card));
        // Each limit of the exercise's own metrics has its sentence, and each metric has one limit.
        QCOMPARE(desktop::limitsInWords(level, kEnglish).size(),
                 static_cast<qsizetype>(1 + limits.others.size()));
        for (const auto& [metric, limit] : limits.others) {
            ++others;
            const auto* row = scoring::findMetric(metric);
            QVERIFY2(row && limits.of(metric) == limit, std::string(metric).c_str());
            QVERIFY2(card.contains(kEnglish.toString(limit, 'g', 3) + QLatin1Char(' ') +
                                   QString::fromUtf8(row->unit.data(), qsizetype(row->unit.size()))),
                     qPrintable(name + QLatin1Char('\n') + card));
        }
        for (const QString& line : desktop::limitsInWords(level, kEnglish)) // the set-up screen says the same
            QVERIFY2(desktop::levelFacts(level, kEnglish).contains(line),
                     qPrintable(name + QStringLiteral(": ") + line));
        for (const scoring::Gate& gate : level.gates) {
            const std::optional<double> shown = shownLimit(limits, gate.metric);
            if (!shown || !gate.maximum)
                continue;
            ++gates;
            const std::optional<double> behind = session::limitBehind(level, gate);
            QVERIFY2(*shown == behind.value_or(*gate.maximum),
                     qPrintable(name + QStringLiteral(": ") + QString::fromStdString(gate.metric)));
        }
        // What is timed over a limit is timed over the one shown, or a stricter pass mark makes it say
        // nothing more.
        const auto kind = session::exerciseKind(level.exercise);
        QVERIFY(kind);
        const bool stricter = limits.force_N < (*kind)->forceLimit_N(level);
        QVERIFY2(stricter || limits.force_N == (*kind)->forceLimit_N(level), qPrintable(name));
        const QString timed =
            desktop::gateInWords({.metric = "force_time_over_limit", .minimum = {}, .maximum = 0.2}, kEnglish)
                .section(QLatin1Char(':'), 0, 0);
        QVERIFY2(!stricter || desktop::gatesInWords(level, kEnglish).filter(timed).isEmpty(),
                 qPrintable(name));
        if (const auto* handling = level.parameters.find<simulation::ObjectHandlingParameters>())
            QCOMPARE(limits.of("squeeze_max").value_or(0.0),
                     handling->squeezeLimit_N); // as the bar, the damage and the time over it have it
        // The scene's arrow and gauges, too.
        QCOMPARE(desktop::sceneSetupOf(level, session::cuesOf(level, false), m_bench.desktop.context.theme(),
                                       false)
                     .forceLimit_N,
                 limits.force_N);
    });
    QVERIFY(gates >= 3); // a squeeze, a force, a pull: content without any would prove nothing
    QVERIFY(others >= 4);
}

/// The lines are in the level's order. Only the time over the force limit has none, and only where another
/// pass mark is stricter than that limit.
void TestEveryReadyCard::everyPassMarkHasItsLine() {
    int told = 0, implied = 0;
    const auto titleOf = [](const QString& line) { return line.section(QLatin1Char(':'), 0, 0); };
    everyLevel([&](const catalogue::ExerciseLevel& level, const QString& name) {
        const auto kind = session::exerciseKind(level.exercise);
        QVERIFY(kind);
        const bool stricter = session::levelLimits(level).force_N < (*kind)->forceLimit_N(level);
        QStringList expected, titles;
        for (const scoring::Gate& gate : level.gates) {
            const bool ofTime = gate.metric == "force_time_over_limit";
            told += ofTime && !stricter ? 1 : 0;
            implied += ofTime && stricter ? 1 : 0;
            if (!ofTime || !stricter)
                expected << titleOf(desktop::gateInWords(gate, kEnglish, (*kind)->trialCount(level)));
        }
        for (const QString& line : desktop::gatesInWords(level, kEnglish))
            titles << titleOf(line);
        QVERIFY2(titles == expected, qPrintable(name + QStringLiteral(": ") + titles.join(u'|')));
    });
    QVERIFY(told >= 1 && implied >= 1); // content without both would prove nothing
}

void TestEveryReadyCard::aPassMarkBesideItsLimitSaysWhy() {
    int allowed = 0;
    everyLevel([&](const catalogue::ExerciseLevel& level, const QString& name) {
        for (const scoring::Gate& gate : level.gates) {
            const std::optional<double> limit = session::limitBehind(level, gate);
            if (!limit)
                continue;
            ++allowed;
            const QString words = desktop::gatesInWords(level, kEnglish).join(QLatin1Char('\n'));
            QVERIFY2(words.contains(newtons(*limit)) &&
                         words.contains(QStringLiteral("time it takes to react")),
                     qPrintable(name + QLatin1Char('\n') + words));
            QVERIFY2(!words.contains(newtons(*gate.maximum)),
                     qPrintable(name + QLatin1Char('\n') + words)); // one number
            report::MetricRow row;
            row.unit = QStringLiteral("N");
            row.gateMaximum = gate.maximum;
            row.limit = limit;
            const QString mark = report::formatGate(row, kEnglish); // debrief and report
            QVERIFY2(mark.contains(report::formatValue(limit, row.unit, kEnglish)) &&
                         mark.contains(QLatin1Char('+')),
                     qPrintable(mark));
            QVERIFY2(!mark.contains(report::formatValue(gate.maximum, row.unit, kEnglish)), qPrintable(mark));
        }
    });
    QVERIFY(allowed >= 1);
}

/// Where an object is to be set down is called the same on the card, in the facts and step by step.
void TestEveryReadyCard::theTargetHasOneName() {
    int levels = 0;
    everyLevel([&](const catalogue::ExerciseLevel& level, const QString& name) {
        const auto* handling = level.parameters.find<simulation::ObjectHandlingParameters>();
        if (!handling)
            return;
        const desktop::Grasping grasping = desktop::handlingGrasping(*handling, session::levelLimits(level));
        ++levels;
        QString words = desktop::levelFacts(level, kEnglish).join(QLatin1Char(' '));
        for (const char* step : {"carry", "place", "hold"}) {
            core::LaparoscopyCues cues;
            cues.objectShown = true;
            cues.step = step[0] == 'c'   ? core::LaparoscopyStep::carry
                        : step[0] == 'p' ? core::LaparoscopyStep::place
                                         : core::LaparoscopyStep::hold;
            const QString told = grasping.step(cues, kEnglish);
            QVERIFY2(told.contains(QStringLiteral("ring")), qPrintable(name + QStringLiteral(": ") + told));
            words += QLatin1Char(' ') + told;
            const std::optional<double> end_mm = session::levelLimits(level).of(
                "placement_error"); // told where it is judged, before and while it is done
            const QString end = QStringLiteral("%1 mm").arg(kEnglish.toString(end_mm.value_or(0.0), 'g', 3));
            QVERIFY2(!end_mm || (desktop::limitsInWords(level, kEnglish).filter(end).size() == 1 &&
                                 (step[0] != 'p' || told.contains(end))),
                     qPrintable(name + QStringLiteral(": ") + told));
        }
        QVERIFY2(QString::fromStdString(level.goal.at("en")).contains(QStringLiteral("ring")),
                 qPrintable(name));
        QVERIFY2(!words.contains(QStringLiteral("dish")), qPrintable(words));
    });
    QVERIFY(levels > 0);
}

void TestEveryReadyCard::goIsAlwaysInSight_data() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<double>("scale");
    for (const char* language : tests::languageIds())
        for (const double scale : {1.0, 2.0})
            QTest::addRow("%s, %.0f %%", language, scale * 100) << QString(QLatin1String(language)) << scale;
}

/// In the smallest window, on the first card, which says what counts and what the marks mean, and on the
/// brief and the whole one.
void TestEveryReadyCard::goIsAlwaysInSight() {
    QFETCH(QString, language);
    QFETCH(double, scale);
    desktop::MainWindow& window = *m_bench.desktop.window;
    m_bench.desktop.settings.setLanguage(language);
    m_bench.desktop.settings.setScale(scale);
    window.resize(1280, 720);
    m_bench.desktop.context.applyAppearance();
    QStringList hidden;
    const auto look = [&](const QString& name) {
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QTest::qWait(0);
        auto* go = window.findChild<QPushButton*>(QStringLiteral("training.ready.go"));
        QVERIFY2(go, qPrintable(name));
        QVERIFY2(
            QTest::qWaitFor([go] { return go->isVisible() && go->width() >= go->minimumSizeHint().width(); },
                            kPatience_ms),
            qPrintable(name));
        QCoreApplication::processEvents();
        const QRect at(go->mapTo(&window, QPoint()), go->size());
        if (!window.rect().contains(at) || go->visibleRegion().boundingRect() != go->rect())
            hidden << name;
        QCOMPARE(window.size(), QSize(1280, 720));
    };
    everyLevel([&](const catalogue::ExerciseLevel& level, const QString& name) {
        m_bench.show({{QStringLiteral("exercise"), QString::fromStdString(level.exercise)},
                      {QStringLiteral("level"), level.number}});
        look(name);
        const auto* gates = window.findChild<QLabel*>(QStringLiteral("training.ready.gates"));
        QVERIFY2(gates && !gates->text().isEmpty(), qPrintable(name));
        const auto* marks = window.findChild<QLabel*>(QStringLiteral("training.ready.marks"));
        QVERIFY2((marks != nullptr) == explainsMarks(level), qPrintable(name));
        const desktop::TrainingPlan plan = desktop::TrainingPlan::fromMap(
            {{QStringLiteral("exercise"), QString::fromStdString(level.exercise)},
             {QStringLiteral("level"), level.number}});
        m_bench.desktop.settings.setOfPerson(m_bench.desktop.context.actor().personId(),
                                             desktop::readyKey(plan), true);
        m_bench.desktop.go(QStringLiteral("training"), plan.toMap());
        look(name + QStringLiteral(", brief"));
        m_bench.desktop.settings.setOfPerson(m_bench.desktop.context.actor().personId(),
                                             desktop::readyKey(plan), false);
        auto* more = window.findChild<QPushButton*>(QStringLiteral("training.ready.more"));
        QVERIFY2(more, qPrintable(name));
        more->click();
        look(name + QStringLiteral(", whole"));
    });
    QVERIFY2(hidden.isEmpty(), qPrintable(hidden.join(QLatin1Char('\n'))));
}

QTEST_MAIN(TestEveryReadyCard)
#include "test_every_ready_card.moc"
