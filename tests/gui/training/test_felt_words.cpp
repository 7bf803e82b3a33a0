// SPDX-License-Identifier: GPL-3.0-or-later
// Words follow the class of the device: with a mouse nobody reads of feeling, on any level, in any language.
// Where somebody does feel the force, the text that fits is there.
#include "gui/training/training_bench.h"

#include "core/languages.h"
#include "desktop/exercise_face.h"
#include "desktop/studies/difference_table.h"
#include "desktop/studies/participant_sentences.h"
#include "desktop/studies/study_words.h"
#include "desktop/study_run/study_controls.h"
#include "desktop/training/felt_words.h"
#include "desktop/training/info_view.h"
#include "desktop/training/training_words.h"
#include "support/feeling_words.h"
#include "support/made_study.h"

#include <QAbstractButton>

using namespace chiron;
using namespace chiron::tests;

namespace {

/// All that can be read in a widget, seen or spoken.
QStringList textsOf(const QWidget& whole) {
    QStringList texts;
    for (const QWidget* part : whole.findChildren<QWidget*>()) {
        texts << part->toolTip() << part->accessibleName() << part->accessibleDescription();
        if (const auto* label = qobject_cast<const QLabel*>(part))
            texts << label->text();
        if (const auto* button = qobject_cast<const QAbstractButton*>(part))
            texts << button->text();
    }
    return texts;
}

void add(QStringList& texts, const std::vector<desktop::ControlHint>& hints) {
    for (const desktop::ControlHint& hint : hints)
        texts << hint.what << hint.how;
}

} // namespace

class TestFeltWords : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { qputenv("CHIRON_NO_SOUND", "1"); }
    void everyLevelInEveryLanguage_data() { eachLanguage(); }
    void everyLevelInEveryLanguage();
    void everyTaskOfAStudy_data() { eachLanguage(); }
    void everyTaskOfAStudy();
    void thePairFitsTheClass();
    void whoWatchesReadsNoClass();

private:
    static void eachLanguage() {
        QTest::addColumn<QString>("language");
        for (const std::string& language : core::languageIds())
            QTest::newRow(language.c_str()) << QString::fromStdString(language);
    }
    void speak(const QString& language) {
        m_bench.desktop.settings.setLanguage(language);
        m_bench.desktop.context.applyAppearance();
    }
    /// What the live part of a level says beside and about its scene.
    QStringList partTexts(const catalogue::ExerciseLevel& level, bool felt) {
        desktop::LiveSurroundings around{.theme = m_bench.desktop.context.theme(),
                                         .locale = m_bench.desktop.context.locale(),
                                         .cues = session::cuesOf(level, felt),
                                         .ownHand = true,
                                         .report = {},
                                         .freePointer = {}};
        const auto part = desktop::exerciseFace(level.exercise).value()->livePart(level, std::move(around));
        const std::unique_ptr<desktop::InfoView> panel(part->makePanel());
        panel->setDetailed(true);
        QStringList texts = textsOf(*panel);
        add(texts, part->guide().begin);
        for (const desktop::LiveCommand& command : part->commands())
            texts << command.text;
        return texts << part->guide().keys << part->activeText(0);
    }

    TrainingBench m_bench;
};

/// The whole screen with the mouse, with its card; and the panel for both classes.
void TestFeltWords::everyLevelInEveryLanguage() {
    QFETCH(QString, language);
    speak(language);
    QStringList faults;
    int unmeasured = 0;
    const auto check = [&](const QString& name, const QStringList& texts, bool palpation) {
        for (const QString& text : texts)
            if (const QString found = feelingIn(text, language, palpation); !found.isEmpty())
                faults << QStringLiteral("%1: \"%2\" in: %3").arg(name, found, text);
    };
    for (const catalogue::Exercise& exercise : m_bench.desktop.site.catalogue().exercises())
        for (const catalogue::ExerciseLevel& level : exercise.levels) {
            const QString name = QString::fromStdString(exercise.id + " " + level.id);
            const bool palpation = exercise.id == "palpation";
            m_bench.show({{QStringLiteral("exercise"), QString::fromStdString(exercise.id)},
                          {QStringLiteral("level"), level.number}});
            QVERIFY2(m_bench.screen(), qPrintable(name));
            check(name, textsOf(*m_bench.screen()), palpation);
            check(name, {m_bench.screen()->help()}, palpation);
            check(name + QStringLiteral(", panel"), partTexts(level, false), palpation);
            const session::LevelCues cues = session::cuesOf(level, true);
            if (cues.bars || cues.numbers || cues.plots || cues.coverage)
                continue;
            ++unmeasured; // whoever feels the force is told to rely on it
            QVERIFY2(partTexts(level, true).contains(desktop::felt_words::noMeasurements(true)),
                     qPrintable(name));
        }
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
    QVERIFY(unmeasured > 0);
}

void TestFeltWords::everyTaskOfAStudy() {
    using namespace psychophysics;
    QFETCH(QString, language);
    speak(language);
    QStringList texts;
    for (int task = 0; task < kTasks; ++task)
        for (int attribute = 0; attribute < kAttributes; ++attribute) {
            const auto [t, a] = std::pair{static_cast<Task>(task), static_cast<Attribute>(attribute)};
            for (const bool pointer : {true, false}) { // a handle may render no force either
                const desktop::StudyHand hand{pointer, false};
                add(texts, desktop::studyControls(t, a, hand));
                texts << desktop::studyKeys(t, a, hand);
            }
            texts << desktop::study_words::question(t, a);
            StudyDesign design = tests::smallStudy("words");
            design.conditions.resize(1);
            desktop::takeTask(design.conditions.front(), t);
            design.conditions.front().stimulus.attribute = a;
            texts << desktop::participantSentences(design, language);
        }
    texts << desktop::felt_words::objects(false);
    for (const QString& text : texts)
        QVERIFY2(feelingIn(text, language).isEmpty(), qPrintable(text));
}

void TestFeltWords::thePairFitsTheClass() {
    speak(QStringLiteral("en"));
    const QString english = QStringLiteral("en");
    for (const auto pair : {&desktop::felt_words::noMeasurements, &desktop::felt_words::objects}) {
        QVERIFY(!feelingIn(pair(true), english).isEmpty());
        QVERIFY2(feelingIn(pair(false), english).isEmpty(), qPrintable(pair(false)));
    }
    const QString mouse = QStringLiteral("Mouse");
    QCOMPARE(desktop::felt_words::device(mouse, true), QStringLiteral("Mouse: force felt"));
    QCOMPARE(desktop::felt_words::device(mouse, false), QStringLiteral("Mouse: force shown, not felt"));
}

/// The driver of a demonstration renders force, which nobody in front of the screen holds: its name says
/// neither. A person's device and a replayed file have their class.
void TestFeltWords::whoWatchesReadsNoClass() {
    speak(QStringLiteral("en"));
    const auto title = [](devices::MovedBy mover) {
        desktop::TrainingPlan plan;
        plan.exercise = QStringLiteral("palpation");
        plan.driver = &devices::usualDriver(mover);
        plan.operatorName = QStringLiteral("novice");
        plan.traceFile = QStringLiteral("/a/folder/hand.csv");
        return desktop::deviceTitle(plan);
    };
    const QString watched = title(devices::MovedBy::scriptedOperator);
    QVERIFY2(watched.startsWith(QStringLiteral("Demonstration (Novice). ")) &&
                 !watched.contains(QStringLiteral("felt")),
             qPrintable(watched));
    for (const devices::MovedBy mover : {devices::MovedBy::person, devices::MovedBy::recording})
        QVERIFY2(title(mover).endsWith(QStringLiteral("force shown, not felt")), qPrintable(title(mover)));
}

QTEST_MAIN(TestFeltWords)
#include "test_felt_words.moc"
