// SPDX-License-Identifier: GPL-3.0-or-later
// Every page of the printed reports, as lines of what is painted (support/paint_outline.h), against what was
// read and kept: sessions of each exercise, however they ended, with what playback shows of them
// (support/track_outline.h), and studies. What a session's recording and scores come to is in it, so that a
// changed force or metric shows here, too. A change that is meant is kept anew, and the difference is read in
// review: CHIRON_STORE_OUTLINES=1 QT_QPA_PLATFORM=offscreen build/release/tests/gui/review/test_kept_reports
#include "desktop/debrief/debrief_data.h"
#include "desktop/debrief/report_words.h"
#include "desktop/people/login_slips.h"
#include "desktop/plots/session_token_words.h"
#include "report/check_record.h"
#include "report/plot_view.h"
#include "report/report_writer.h"
#include "report/session_plots.h"
#include "review_sessions.h"
#include "session/study/study_runner.h"
#include "session_report/study_report.h"
#include "support/insertion_session.h"
#include "support/kept_text.h"
#include "support/looked_back.h"
#include "support/made_study.h"
#include "support/of_today.h"
#include "support/paint_outline.h"
#include "support/palpation_session.h"
#include "support/track_outline.h"

#include <qcustomplot.h>

using namespace chiron;
using namespace chiron::tests;

class TestKeptReports : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void sessionIsPaintedAsItWas_data();
    void sessionIsPaintedAsItWas();
    void studyIsPaintedAsItWas_data();
    void studyIsPaintedAsItWas();
    void comparisonIsPaintedAsItWas();
    void checkIsPaintedAsItWas();
    void slipsArePaintedAsTheyWere();
    void nothingElseIsKept() { QCOMPARE(m_kept.unseen(), QStringList()); }
    void cleanupTestCase() { m_site.reset(); }

private:
    database::SessionId scripted(const std::string& exercise, int level, const std::string& operatorName,
                                 int trials, double limit_s);
    database::SessionId anew(database::SessionId id, const std::function<void(MadeSession&)>& change);
    database::StudyNumber frozen(const psychophysics::StudyDesign& design);
    database::Participant program(database::StudyNumber study, const std::string& code, double weber);
    database::StudyNumber ofRankings();
    database::StudyNumber sealed();
    database::StudyNumber byPrograms(const psychophysics::StudyDesign& design);

    std::unique_ptr<DesktopFixture> m_site;
    std::optional<database::Actor> m_tina;
    database::Actor m_rhea = database::Actor::simulated(); ///< until she has logged in
    KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/review/kept_reports.txt"),
                    &KeptText::nearly};
};

void TestKeptReports::initTestCase() {
    m_site = std::make_unique<DesktopFixture>();
    m_tina = m_site->actor("tina");
    m_rhea = m_site->actor("rhea");
    m_site->context.logIn(*m_tina);
}

/// A level as it is shipped with fewer and shorter trials, by a scripted operator: to be done again as
/// tina's.
database::SessionId TestKeptReports::scripted(const std::string& exercise, int level,
                                              const std::string& operatorName, int trials, double limit_s) {
    QJsonObject json =
        QJsonDocument::fromJson(
            QByteArray::fromStdString(m_site->context.site().catalogue().find(exercise, level)->resolvedJson))
            .object();
    QJsonObject inner = json["level"].toObject();
    QJsonObject parameters = inner["parameters"].toObject();
    parameters["trial_limit_s"] = limit_s;
    if (parameters.contains("trials"))
        parameters["trials"] = trials;
    inner["parameters"] = parameters;
    json["level"] = inner;
    session::TrainingRequest request;
    request.level =
        catalogue::fromResolvedJson(QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString()).value();
    request.seed = 11;
    request.ringFolder = recording::defaultRingFolder();
    auto station = session::scriptedStation(**session::exerciseKind(exercise), request.level, operatorName,
                                            request.seed);
    if (!station)
        qFatal("%s", station.error().message.c_str());
    request.station = std::move(*station);
    auto result = session::runTraining(m_site->database(), database::Actor::simulated(), std::move(request));
    if (!result)
        qFatal("%s", result.error().message.c_str());
    return result->session;
}

/// The same session once more, changed, by tina's own hand.
database::SessionId TestKeptReports::anew(database::SessionId id,
                                          const std::function<void(MadeSession&)>& change) {
    MadeSession made = copyOf(m_site->database(), id);
    made.operatorName.clear();
    change(made);
    return store(m_site->database(), *m_tina, made);
}

void TestKeptReports::sessionIsPaintedAsItWas_data() {
    QTest::addColumn<qlonglong>("session");
    QTest::addColumn<QString>("exercise");
    QTest::addColumn<QString>("language");
    const auto row = [](const char* name, database::SessionId id, const char* exercise,
                        const char* language = "en") {
        QTest::newRow(name) << qlonglong(id) << QString::fromLatin1(exercise)
                            << QString::fromLatin1(language);
    };
    const auto stop = [](MadeSession& made) {
        cutFrames(made.frames, made.frames.size() * 2 / 3, core::CommandKind::end);
        made.ending.stopped = true;
    };
    const database::SessionId apex = scripted("sphere_apex", 2, "expert", 3, 12.0);
    row("apex_by_script", anew(apex, [](MadeSession& made) { made.operatorName = "expert"; }), "sphere_apex");
    row("apex_stopped", anew(apex, stop), "sphere_apex");
    row("apex_not_begun",
        anew(apex,
             [](MadeSession& made) {
                 cutFrames(made.frames, 40, core::CommandKind::end);
                 made.ending.stopped = true;
             }),
        "sphere_apex");
    row("apex_shown_and_late",
        anew(apex,
             [](MadeSession& made) {
                 for (devices::DeviceDescriptor& device : made.setup.devices)
                     device.rendersForce = false;
                 pauseFrames(made.frames, 700, 1500);
                 for (auto& frame : made.frames) // the first trial's mark is none
                     if ((frame.header.events & core::event_bits::kMarked) != 0) {
                         frame.header.events =
                             (frame.header.events & ~core::event_bits::kMarked) | core::event_bits::kTimedOut;
                         break;
                     }
             }),
        "sphere_apex");
    row("apex_failed", anew(scripted("sphere_apex", 1, "unsafe", 2, 12.0), [](MadeSession&) {}),
        "sphere_apex", "de");
    row("urethra", addInsertion(*m_site, "tina", 1, 0.065, 0.0015), "urethra_insertion");
    row("urethra_not_deep", addInsertion(*m_site, "tina", 1, 0.040), "urethra_insertion");
    const database::SessionId tube = scripted("elastic_tube", 1, "intermediate", 2, 25.0);
    row("tube", anew(tube, [](MadeSession&) {}), "elastic_tube");
    row("tube_stopped", anew(tube, stop), "elastic_tube");
    row("tube_two_hands", anew(scripted("elastic_tube", 4, "intermediate", 2, 25.0), [](MadeSession&) {}),
        "elastic_tube");
    row("handling", anew(scripted("object_handling", 1, "intermediate", 2, 30.0), [](MadeSession&) {}),
        "object_handling");
    row("handling_unsafe", anew(scripted("object_handling", 1, "unsafe", 2, 30.0), [](MadeSession&) {}),
        "object_handling");
    const database::SessionId palpation = addPalpation(*m_site, "tina");
    row("palpation", palpation, "palpation");
    row("palpation_german", palpation, "palpation", "de");
    row("palpation_two_fingers", anew(scripted("palpation", 4, "intermediate", 1, 20.0), [](MadeSession&) {}),
        "palpation");
}

void TestKeptReports::sessionIsPaintedAsItWas() {
    QFETCH(qlonglong, session);
    QFETCH(QString, exercise);
    QFETCH(QString, language);
    m_site->settings.setLanguage(language);
    m_site->context.applyAppearance();
    auto connection = m_site->database().openReader();
    auto data = desktop::loadReport(**connection, *m_tina, session, language.toStdString());
    QVERIFY2(data, data ? "" : data.error().message.c_str());
    desktop::translateReport(
        *data, {QStringLiteral("Tina Trainee"),
                desktop::exerciseTitle(m_site->context.site().catalogue(), exercise.toStdString(), language),
                QStringLiteral("device")});
    // What is of today and of this build.
    data->startedUtc = QDateTime(QDate(2026, 11, 20), QTime(11, 23, 45), Qt::UTC);
    data->offsetMinutes = 60;
    QVERIFY(!data->integrity.buildId.isEmpty() && data->integrity.contentSha256.size() == 64 &&
            data->integrity.recordingDigest.size() == 64 && data->integrity.bytes > 0);
    data->integrity.buildId = QStringLiteral("0.1.0 gcc-12.2.0");
    data->integrity.contentSha256 = QString(64, QLatin1Char('c'));
    QCOMPARE(data->integrity.taskSha256.size(), 64);
    data->integrity.taskSha256 = QString(64, QLatin1Char('b'));
    data->integrity.recordingDigest = QString(64, QLatin1Char('d'));
    data->integrity.bytes = 3481220;
    OutlinePages pages;
    QVERIFY(report::paintSession(pages, *data, report::lightTheme(m_site->context.locale())));
    const QString differs = m_kept.differs(QLatin1String(QTest::currentDataTag()), pages.take());
    QVERIFY2(differs.isEmpty(), qPrintable(differs));
    // And what playback shows of the same session, by its marks' own words.
    auto stored = session::SessionView::open(**connection, *m_tina, session);
    QVERIFY2(stored, stored ? "" : stored.error().message.c_str());
    auto track = tests::trackOf(**stored);
    const auto card = (*stored)->computeScores();
    QVERIFY2(track && card, track ? card ? "" : card.error().message.c_str() : track.error().message.c_str());
    if (track->empty())
        return;
    const QString moved =
        m_kept.differs(QLatin1String(QTest::currentDataTag()) + QStringLiteral(", playback"),
                       TrackOutline(*track, (*stored)->setup().level, *card).lines());
    QVERIFY2(moved.isEmpty(), qPrintable(moved));
}

/// Frozen. Of people codes are drawn, whose width would move words from line to line: who does it are
/// programs with codes of their own.
database::StudyNumber TestKeptReports::frozen(const psychophysics::StudyDesign& design) {
    const database::StudyNumber study = addDraft(*m_site, m_rhea, design);
    writeAs(*m_site, m_rhea, [&](database::StudyRepository& all) { return all.freezeStudy(study); });
    return study;
}

database::Participant TestKeptReports::program(database::StudyNumber study, const std::string& code,
                                               double weber) {
    const std::string observer = "weber:" + std::to_string(weber).substr(0, 4);
    return *writeAs(*m_site, m_rhea, [&](database::StudyRepository& all) {
        return all.enrolParticipant(study, {}, 0, observer, code);
    });
}

/// Of two conditions and a questionnaire, by three who differ and one who has not begun.
database::StudyNumber TestKeptReports::ofRankings() {
    const psychophysics::StudyDesign design = smallStudy("jnd_stiffness_mass");
    const database::StudyNumber study = frozen(design);
    std::uint64_t seed = 7;
    for (const auto& [code, weber] : {std::pair{"ALPHA", 0.08}, {"BRAVO", 0.11}, {"CHARLIE", 0.16}}) {
        const auto participant = program(study, code, weber);
        addRun(*m_site, m_rhea, design, participant, "stiffness", weber, seed);
        addRun(*m_site, m_rhea, design, participant, "mass", 1.3 * weber, 10 + seed);
        addAnswers(*m_site, m_rhea, participant, static_cast<int>(seed++) % 3 + 3);
        writeAs(*m_site, m_rhea,
                [&](database::StudyRepository& all) { return all.completeParticipant(participant.id); });
    }
    addParticipant(*m_site, m_rhea, study, design, "surgeon 4");
    return study;
}

database::StudyNumber TestKeptReports::sealed() {
    psychophysics::StudyDesign design = smallStudy("sealed", true);
    design.conditions.resize(1); // of several the order is that of their codes, which are drawn
    const database::StudyNumber study = frozen(design);
    for (const auto& [code, seed] : {std::pair{"ALPHA", 41}, {"BRAVO", 42}})
        addRun(*m_site, m_rhea, design, program(study, code, 0.1), "stiffness", 0.1,
               static_cast<std::uint64_t>(seed));
    return study;
}

/// As the program does them itself.
database::StudyNumber TestKeptReports::byPrograms(const psychophysics::StudyDesign& design) {
    const database::StudyNumber study = frozen(design);
    for (const auto& [code, weber] : {std::pair{"ALPHA", 0.1}, {"BRAVO", 0.15}}) {
        program(study, code, weber);
        session::StudyRunRequest request;
        request.study = study;
        request.participantCode = code;
        request.observer.weber = weber;
        request.quick = true;
        if (const auto run = session::runStudyHeadless(m_site->database(), m_rhea, request); !run)
            qFatal("%s", run.error().message.c_str());
    }
    return study;
}

void TestKeptReports::studyIsPaintedAsItWas_data() {
    QTest::addColumn<qlonglong>("study");
    QTest::addColumn<QString>("language");
    const auto row = [](const char* name, database::StudyNumber number, const char* language = "en") {
        QTest::newRow(name) << qlonglong(number) << QString::fromLatin1(language);
    };
    const database::StudyNumber rankings = ofRankings();
    row("study", rankings);
    row("study_german", rankings, "de");
    row("study_blind", sealed());
    row("study_apex", byPrograms(apexStudy("apex", 12)));
    psychophysics::StudyDesign choices = smallStudy("choices"); // which of two is more
    choices.questionnaires.clear();
    for (psychophysics::Condition& condition : choices.conditions) {
        condition.task = psychophysics::Task::twoAfc;
        condition.stimulus.differences = {0.02, 0.05, 0.09, 0.14};
        condition.procedures = {psychophysics::ConstantSpec{condition.stimulus.differences, 12, true}};
    }
    row("study_of_choices", byPrograms(choices));
}

void TestKeptReports::studyIsPaintedAsItWas() {
    QFETCH(qlonglong, study);
    QFETCH(QString, language);
    m_site->settings.setLanguage(language);
    m_site->context.applyAppearance();
    auto connection = m_site->database().openReader();
    database::StudyReader reader(**connection, m_rhea);
    QStringList drawn; // codes, which a line may break
    const auto codes = reader.conditionCodes(study);
    for (const database::SealedCondition& each : codes.value_or(std::vector<database::SealedCondition>()))
        drawn << QString::fromStdString(each.sealedCode)
              << QString::fromStdString(each.sealedCode).split(QLatin1Char('-'));
    OutlinePages pages([&drawn](const QString& text) {
        QString said = withoutToday(text);
        for (const QString& code : drawn)
            said.replace(code, QStringLiteral("0"));
        return said;
    });
    const auto painted = session_report::paintStudyReport(
        pages, reader, study, report::lightTheme(m_site->context.locale()), language.toStdString());
    QVERIFY2(painted, painted ? "" : painted.error().message.c_str());
    const QString differs = m_kept.differs(QLatin1String(QTest::currentDataTag()), pages.take());
    QVERIFY2(differs.isEmpty(), qPrintable(differs));
}

void TestKeptReports::comparisonIsPaintedAsItWas() {
    report::ComparisonData data{QStringLiteral("Apex error of the scripted operators"),
                                QStringLiteral("Mean apex error"),
                                QStringLiteral("% of radius"),
                                {{QStringLiteral("novice"), {38.1, 44.0, 31.2, 52.7, 40.1, 35.5}},
                                 {QStringLiteral("expert"), {9.8, 11.7, 8.9, 13.2, 10.4, 9.1}},
                                 {QStringLiteral("unsafe"), {16.2}},
                                 {QStringLiteral("nobody"), {}}},
                                QStringLiteral("trial"),
                                14.2,
                                QStringLiteral("published mean, 14.2 %")};
    for (const char* name : {"comparison", "comparison_below_zero"}) {
        OutlineDevice device(QSize(900, 460));
        QCPPainter painter;
        QVERIFY(painter.begin(&device));
        painter.setMode(QCPPainter::pmVectorized);
        report::comparisonPlot(data, report::lightTheme(QLocale(QLocale::English, QLocale::UnitedKingdom)))
            ->paintTo(painter, QRectF(0, 0, 900, 460));
        painter.end();
        const QString differs = m_kept.differs(QLatin1String(name), device.take());
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
        data.groups[2].values = {-3.0, 16.2};
        data.reference.reset();
        data.pointLabel.clear();
        data.unit.clear();
    }
}

/// A record of a check over two pages: paragraphs, a table that is cut by the page's end, plots.
void TestKeptReports::checkIsPaintedAsItWas() {
    const report::PlotTheme theme = report::lightTheme(QLocale(QLocale::English, QLocale::UnitedKingdom));
    report::PlotView plot(theme);
    plot.addLine(QStringLiteral("force"), std::vector<double>{0.0, 1.0, 2.0, 3.0},
                 std::vector<double>{0.5, 1.5, 1.0, 2.0}, report::PlotStyle::solidA);
    report::CheckRecord record;
    record.title = QStringLiteral("Verification of a platform");
    record.when = QStringLiteral("On a Tuesday, in the laboratory");
    record.verdict = QStringLiteral("It holds.");
    record.facts = {QStringLiteral("Force within 0.07 N of what was asked for, over three cycles of a sine "
                                   "of one newton at half a hertz, which is what the figure shows, "
                                   "and angles within two degrees."),
                    QStringLiteral("Simulated.")};
    report::CheckTable figures{
        QStringLiteral("Figures"),
        {{QStringLiteral("what"), QStringLiteral("here"), QStringLiteral("published")}}};
    for (int row = 0; row < 34; ++row)
        figures.lines.push_back(
            {QStringLiteral("row %1").arg(row),
             row % 9 == 4
                 ? QStringLiteral("a cell with so many words that it takes more than one line of its column")
                 : QString::number(0.5 * row),
             QStringLiteral("1.95")});
    figures.lines.insert(figures.lines.begin() + 3, QStringList()); // nothing: left out
    record.tables = {figures,
                     {QStringLiteral("Fingers"),
                      {{QStringLiteral("finger"), QStringLiteral("rmse")},
                       {QStringLiteral("soft"), QStringLiteral("0.05")}}}};
    record.plots = {&plot, &plot};
    OutlinePages pages;
    QVERIFY(report::paintCheck(pages, record, theme));
    QCOMPARE(pages.pages(), 2);
    const QString differs = m_kept.differs(QStringLiteral("check"), pages.take());
    QVERIFY2(differs.isEmpty(), qPrintable(differs));
}

/// One person with a full name and one without, at a site with a name and at one without.
void TestKeptReports::slipsArePaintedAsTheyWere() {
    desktop::LoginSlips slips{
        QStringLiteral("Skills lab"),
        {{1, "uma", "Uma Unknown", "seven-grey-geese"},
         {2, "vic", "", "a-password-so-long-that-it-may-not-fit-on-one-line-of-a-slip"}}};
    for (const char* name : {"slips", "slips of a site without a name"}) {
        OutlinePages pages;
        QVERIFY(desktop::paintLoginSlips(
            pages, slips, report::lightTheme(QLocale(QLocale::English, QLocale::UnitedKingdom))));
        const QString differs = m_kept.differs(QLatin1String(name), pages.take());
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
        slips.site.clear();
    }
}

QTEST_MAIN(TestKeptReports)
#include "test_kept_reports.moc"
