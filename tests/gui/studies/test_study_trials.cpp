// SPDX-License-Identifier: GPL-3.0-or-later
// A sitting: instructions, trials by keyboard, stop, and on again at the same trial.
#include "desktop/study_run/trials_screen.h"
#include "desktop/widgets/state_panel.h"
#include "support/kept_text.h"
#include "support/languages.h"
#include "support/patience.h"
#include "support/screen_outline.h"
#include "support/sitting_hands.h"

#include <QComboBox>
#include <QLabel>

using chiron::tests::kPatience_ms;

using namespace chiron;
using State = session::LiveStudyView::State;

class TestStudyTrials : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void cleanupTestCase() { m_site.reset(); }
    void unknownParticipantIsSaid();
    void trialsAreAnsweredAndKept();
    void offeredOnTheRunScreen();
    void goesOnWhereItStopped();
    void refusalsOfADeviceHaveWords();
    void studiesOfOneTitleAreToldApart();

private:
    desktop::TrialsScreen* sit(const QString& code);
    void press(desktop::TrialsScreen* screen, const char* button) {
        screen->findChild<QPushButton*>(QLatin1String(button))->click();
    }
    QString where(desktop::TrialsScreen* screen);
    bool canAnswer(desktop::TrialsScreen* screen);
    void stop(desktop::TrialsScreen* screen);
    std::vector<database::StudyTrial> stored();

    std::unique_ptr<tests::DesktopFixture> m_site;
    database::StudyNumber m_study = 0;
    database::Participant m_participant;
    std::size_t m_stored = 0;
    std::vector<database::StudyTrial> m_trials;
    psychophysics::StudyDesign m_design;
};

void TestStudyTrials::initTestCase() {
    m_site = std::make_unique<tests::DesktopFixture>();
    const database::Actor rhea = m_site->actor("rhea");
    psychophysics::StudyDesign design = tests::smallStudy("trials");
    design.trial.mustTouchAll = false;
    design.trial.betweenTrials_s = 0.1;
    m_design = design;
    m_study = tests::addDraft(*m_site, rhea, design);
    tests::writeAs(*m_site, rhea,
                   [&](database::StudyRepository& studies) { return studies.freezeStudy(m_study); });
    m_participant = tests::addParticipant(*m_site, rhea, m_study, design, "somebody");
    m_site->logIn("rhea");
}

desktop::TrialsScreen* TestStudyTrials::sit(const QString& code) {
    m_site->go(QStringLiteral("study_trials"), {{QStringLiteral("study"), qlonglong(m_study)},
                                                {QStringLiteral("participant"), code},
                                                {QStringLiteral("condition"), QStringLiteral("stiffness")}});
    return m_site->screen<desktop::TrialsScreen>();
}

/// What a failure says of a sitting. Buttons are looked for on its own screen: the one before it still lives
/// until the event loop turns.
QString TestStudyTrials::where(desktop::TrialsScreen* screen) {
    if (!screen->live())
        return QStringLiteral("no sitting");
    const session::LiveStudyView view = screen->live()->view();
    const session::LiveStudyNumbers numbers = screen->live()->numbers();
    const auto* panel = screen->findChild<desktop::StatePanel*>();
    return QStringLiteral("state %1, session %2, scored %3, spoiled %4 (%5), panel %6, ended %7")
        .arg(static_cast<int>(view.state))
        .arg(screen->live()->training().sessionId())
        .arg(numbers.scored)
        .arg(numbers.spoiled)
        .arg(QString::fromStdString(numbers.lastSpoiled))
        .arg(static_cast<int>(panel->state()))
        .arg(screen->live()->training().finished());
}

bool TestStudyTrials::canAnswer(desktop::TrialsScreen* screen) {
    return QTest::qWaitFor([screen] { return screen->live()->view().canAnswer; }, kPatience_ms);
}

std::vector<database::StudyTrial> TestStudyTrials::stored() {
    auto connection = m_site->database().openReader();
    database::StudyReader reader(**connection, m_site->context.actor());
    const auto runs = reader.runs(m_participant.id);
    return runs && !runs->empty() ? *reader.studyTrials(runs->back().id)
                                  : std::vector<database::StudyTrial>();
}

void TestStudyTrials::stop(desktop::TrialsScreen* screen) {
    QVERIFY(tests::stopSitting(*m_site, screen));
}

void TestStudyTrials::unknownParticipantIsSaid() {
    desktop::TrialsScreen* screen = sit(QStringLiteral("ZZZ-ZZZ"));
    QVERIFY(screen && !screen->live());
    QCOMPARE(screen->findChild<desktop::StatePanel*>()->state(), desktop::StatePanel::State::error);
}

void TestStudyTrials::trialsAreAnsweredAndKept() {
    desktop::TrialsScreen* screen = sit(QString::fromStdString(m_participant.code));
    QVERIFY(screen && screen->live());
    // Before the first moment of it, against what was read and kept: CHIRON_STORE_OUTLINES=1
    // QT_QPA_PLATFORM=offscreen build/release/tests/gui/studies/test_study_trials
    tests::KeptText kept(QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/studies/kept_trials.txt"));
    const QString differs = kept.differs(QStringLiteral("trials"), tests::ScreenOutline::of(*screen));
    QVERIFY2(differs.isEmpty(), qPrintable(differs));
    for (const QLabel* label : screen->findChildren<QLabel*>()) // no value and no name of a condition
        QVERIFY2(!label->text().contains(QStringLiteral("N/m")) &&
                     !label->text().contains(QStringLiteral("Stiffness")),
                 qPrintable(label->text()));
    QVERIFY2(tests::beginTrials(screen), qPrintable(where(screen)));
    for (int trial = 0; trial < 3; ++trial) {
        QVERIFY2(canAnswer(screen), qPrintable(where(screen)));
        const session::LiveStudyNumbers before = screen->live()->numbers();
        for (const char* button : {"answer.2", "answer.0", "answer.confirm"})
            press(screen, button);
        QTRY_VERIFY_WITH_TIMEOUT(screen->live()->numbers().scored + screen->live()->numbers().spoiled >
                                     before.scored + before.spoiled,
                                 kPatience_ms);
    }
    press(screen, "trials.experimenter");
    QVERIFY(tests::typePassword(*m_site));
    QTRY_VERIFY_WITH_TIMEOUT(
        !screen->findChild<QLabel*>(QStringLiteral("experimenter.progress"))->text().isEmpty(), kPatience_ms);
    stop(screen);
    m_trials = stored();
    m_stored = m_trials.size();
    QVERIFY(m_stored >= 3);
}

/// What was left is said with its trial and moment, also beside somebody else's conditions; one click goes
/// on.
void TestStudyTrials::offeredOnTheRunScreen() {
    const QString code = QString::fromStdString(m_participant.code);
    const QString other = QString::fromStdString(
        tests::addParticipant(*m_site, m_site->context.actor(), m_study, m_design, "somebody else").code);
    const auto open = [&](const QString& participant) {
        m_site->go(QStringLiteral("study_run"), {{QStringLiteral("study"), qlonglong(m_study)},
                                                 {QStringLiteral("participant"), participant}});
        QVERIFY(tests::waitUntilLoaded(*m_site));
    };
    open({}); // nobody asked for: whoever was interrupted
    const auto scored =
        std::count_if(m_trials.begin(), m_trials.end(),
                      [](const database::StudyTrial& trial) { return trial.spoiled.empty(); });
    auto* state = m_site->find<QLabel>(QStringLiteral("run.state.0"));
    auto* second = m_site->find<QLabel>(QStringLiteral("run.state.1"));
    QVERIFY(state && second);
    const QString told = state->text() + second->text();
    QVERIFY2(told.contains(QStringLiteral("interrupted at trial %1 of at most 40").arg(scored + 1)),
             qPrintable(told));
    QVERIFY(!m_site->find<QFrame>(QStringLiteral("run.left"))); // nobody else was
    open(other);
    auto* go = m_site->find<QPushButton>(QStringLiteral("run.resume.%1").arg(code));
    QVERIFY(go);
    QCOMPARE(go->text(), QStringLiteral("Resume here"));
    if (const QString folder = qEnvironmentVariable("CHIRON_KEEP_PICTURES"); !folder.isEmpty())
        m_site->window->grab().save(folder + QStringLiteral("/run_interrupted.png"));
    go->click();
    auto* screen = m_site->screen<desktop::TrialsScreen>();
    QVERIFY(screen);
    QVERIFY(screen->live());
    QCOMPARE(screen->live()->numbers().scored, static_cast<int>(scored));
    stop(screen);
    QCOMPARE(m_site->context.navigator().current().parameters.value(QStringLiteral("participant")).toString(),
             code);
    m_stored = stored().size();
}

void TestStudyTrials::goesOnWhereItStopped() {
    desktop::TrialsScreen* screen = sit(QString::fromStdString(m_participant.code));
    QVERIFY(screen && screen->live());
    QCOMPARE(screen->live()->numbers().scored + screen->live()->numbers().spoiled,
             static_cast<int>(m_stored));
    press(screen, "trials.experimenter");
    QVERIFY(
        tests::typePassword(*m_site)); // no trial of this sitting yet: nothing counted, and nothing is sealed
    const auto beside = [screen] {
        QString words;
        for (const QLabel* label : screen->findChildren<QLabel*>())
            words += label->text() + QLatin1Char('\n');
        return words;
    };
    QTRY_VERIFY2_WITH_TIMEOUT(
        beside().contains(QStringLiteral("The fidelity of each trial will appear here")),
        qPrintable(beside()), kPatience_ms);
    QVERIFY(!beside().contains(QStringLiteral("sealed")));
    stop(screen);
    QVERIFY(stored().size() >= m_stored);
}

/// In the language of the program; whatever else is refused keeps its own words.
void TestStudyTrials::refusalsOfADeviceHaveWords() {
    session::SittingError none(
        {core::ErrorCode::badInput, "condition \"stiffness\": the device renders none of its differences"});
    none.device = session::DeviceRefusal::rendersNone;
    session::SittingError less(
        {core::ErrorCode::wrongUse, "run 1 was begun on a device that renders larger differences"});
    less.device = session::DeviceRefusal::rendersLess;
    session::SittingError stiff({core::ErrorCode::badInput, "a sphere of 500 N/m"});
    stiff.tooStiff = {500.0, 98.0};
    session::SittingError version(
        {core::ErrorCode::wrongUse, "run 1 was begun with quest@2, and this program has quest@3"});
    version.otherVersion = true;
    const session::SittingError other({core::ErrorCode::notFound, "nobody"});
    QStringList told;
    for (const char* language : tests::languageIds()) {
        m_site->settings.setLanguage(QLatin1String(language));
        m_site->context.applyAppearance();
        for (const session::SittingError* error : {&none, &less, &stiff, &version}) {
            const QString words = desktop::TrialsScreen::refusalWords(*error, m_site->context.locale());
            QVERIFY(!words.isEmpty() && !words.contains(QLatin1String(error->message.c_str())));
            QVERIFY2(!told.contains(words), qPrintable(words));
            told << words;
        }
        QVERIFY(desktop::TrialsScreen::refusalWords(other, m_site->context.locale()).isEmpty());
    }
    m_site->settings.setLanguage(QStringLiteral("en"));
    m_site->context.applyAppearance();
}

void TestStudyTrials::studiesOfOneTitleAreToldApart() {
    const psychophysics::StudyDesign twin = tests::smallStudy("twin"); // of the same title
    const auto second = tests::addDraft(*m_site, m_site->context.actor(), twin);
    tests::writeAs(*m_site, m_site->context.actor(),
                   [&](database::StudyRepository& studies) { return studies.freezeStudy(second); });
    for (const auto& [screen, name] : {std::pair{"study_run", "run.study"}, {"study_data", "data.study"}}) {
        m_site->go(QLatin1String(screen), {{QStringLiteral("study"), qlonglong(m_study)}});
        QVERIFY(tests::waitUntilLoaded(*m_site));
        const auto* choice = m_site->find<QComboBox>(QLatin1String(name));
        QVERIFY(choice && choice->count() == 2);
        QVERIFY2(choice->itemText(0) != choice->itemText(1), qPrintable(choice->itemText(0)));
    }
}

QTEST_MAIN(TestStudyTrials)
#include "test_study_trials.moc"
