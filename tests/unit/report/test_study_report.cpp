// SPDX-License-Identifier: GPL-3.0-or-later
// The printed report of a study, as pdftotext reads it. CHIRON_KEEP_PICTURES=<folder> keeps the files.
#include "catalogue/study_json.h"
#include "database/repositories/study_repository.h"
#include "session/study/study_runner.h"
#include "session_report/study_report.h"
#include "support/pdf_text.h"
#include "support/session_fixture.h"
#include "support/study_designs.h"

#include <QDir>
#include <QRegularExpression>
#include <QtTest>
#include <tuple>

using namespace chiron;

namespace {

psychophysics::StudyDesign designOf(const std::string& id, bool blind) {
    psychophysics::StudyDesign study;
    study.id = id;
    study.title = {{"en", "Feeling stiffness"}, {"de", "Steifigkeit fühlen"}};
    study.objective = {{"en", "How small a difference is felt."}};
    study.instructions = {{"en", "Put the three in order."}};
    study.consent = {{"en", "I take part of my own free will."}};
    psychophysics::Condition condition;
    condition.id = "soft";
    condition.title = {{"en", "Softwood tube"}};
    condition.stimulus = testing::stimulusOf(psychophysics::Attribute::stiffness);
    condition.procedures = {testing::rank3(condition.stimulus.differences, 24, 12)};
    study.conditions = {condition};
    psychophysics::Questionnaire questions;
    questions.id = "after";
    questions.title = {{"en", "Face validity"}};
    questions.items = {{"realism",
                        {{"en", "How real did it feel?"}},
                        psychophysics::QuestionnaireItem::Kind::likert,
                        5,
                        {{"en", "not at all"}},
                        {{"en", "fully"}},
                        {},
                        "face",
                        0,
                        0,
                        true}};
    study.questionnaires = {questions};
    study.trial.practiceTrials = 0;
    study.blindExperimenter = blind;
    return study;
}

/// One word after another, however lines were broken. Punctuation between capitals may be missing: the font
/// has glyphs of its own for it.
QString textOf(const QString& pdf) {
    return tests::pdfText(pdf).simplified();
}

} // namespace

class TestStudyReport : public QObject {
    Q_OBJECT
private slots:
    void refusesDraft();
    void tellsAll();
    void blindUntilUnblinded();
    void blindToUnlikeConditions();
    void tellsOfMarks();

private:
    template <class Job> auto write(Job job) {
        return m_site.database->write([&](database::WriteContext& writing) {
            database::StudyRepository studies(writing.connection(), database::Actor::simulated());
            return job(studies);
        });
    }
    database::StudyNumber draft(const psychophysics::StudyDesign& design) {
        const auto study = write([&](database::StudyRepository& all) {
            return all.createStudy(design.id, design.title.at("en"),
                                   catalogue::studyJson(design).toStdString());
        });
        if (!study)
            qFatal("%s", study.error().message.c_str());
        return *study;
    }
    /// Frozen, done by two simulated participants.
    database::StudyNumber done(const psychophysics::StudyDesign& design, std::string& sha256) {
        const auto study = draft(design);
        const auto frozen = write([&](database::StudyRepository& all) { return all.freezeStudy(study); });
        if (!frozen)
            qFatal("%s", frozen.error().message.c_str());
        sha256 = *frozen;
        double answer = 4.0;
        for (const auto& [code, words, weber] :
             {std::tuple{"ALPHA", "weber:0.1", 0.1}, std::tuple{"BRAVO", "weber:0.15", 0.15}}) {
            const auto participant =
                write([&, name = code, observer = words](database::StudyRepository& all) {
                    return all.enrolParticipant(study, {}, 0, observer, name);
                });
            session::StudyRunRequest request;
            request.study = study;
            request.participantCode = participant ? participant->code : std::string();
            request.observer.weber = weber;
            request.quick = true;
            if (const auto run =
                    session::runStudyHeadless(*m_site.database, database::Actor::simulated(), request);
                !run || !run->completed)
                qFatal("%s", run ? "not completed" : run.error().message.c_str());
            if (!design.questionnaires.empty())
                write([&](database::StudyRepository& all) {
                    return all.storeQuestionnaireAnswers(
                        {{participant->id, design.questionnaires.front().id, "realism", answer++, {}, {}}});
                });
        }
        return study;
    }
    static report::PlotTheme theme() {
        return report::lightTheme(QLocale(QLocale::English, QLocale::UnitedKingdom));
    }
    core::Result<void> report(database::StudyNumber study, const QString& file,
                              const std::string& language = "en") {
        auto connection = m_site.database->openReader();
        database::StudyReader reader(**connection, database::Actor::simulated());
        return session_report::writeStudyReport(file, reader, study, theme(), language);
    }
    QString file(const char* name) const {
        const QString kept = qEnvironmentVariable("CHIRON_KEEP_PICTURES");
        return kept.isEmpty() ? m_folder.filePath(QLatin1String(name))
                              : QDir(kept).filePath(QLatin1String(name));
    }
    tests::SessionFixture m_site;
    QTemporaryDir m_folder;
};

void TestStudyReport::refusesDraft() {
    const auto study = draft(designOf("not_yet", false));
    const auto refused = report(study, file("draft.pdf"));
    QVERIFY(!refused && refused.error().code == core::ErrorCode::wrongUse);
    QVERIFY(!QFile::exists(m_folder.filePath(QStringLiteral("draft.pdf"))));
}

void TestStudyReport::tellsAll() {
    std::string sha256;
    const auto study = done(designOf("jnd_soft", false), sha256);
    const auto written = report(study, file("study.pdf"));
    QVERIFY2(written, written ? "" : written.error().message.c_str());
    const QString text = textOf(file("study.pdf"));
    QCOMPARE(sha256.size(), std::size_t{64});
    for (const QString& word :
         {QString::fromStdString(sha256), QStringLiteral("Feeling stiffness"),
          QStringLiteral("Softwood tube"), QStringLiteral("ALPHA"), QStringLiteral("BRAVO"),
          QStringLiteral("150 N/m"), QStringLiteral("2 participant"), QStringLiteral("Fidelity"),
          QStringLiteral("How real did it feel?"), QStringLiteral("Weber fraction of the group"),
          QStringLiteral("Page"), QStringLiteral("Worth of each object")})
        QVERIFY2(text.contains(word), qPrintable(word + QStringLiteral(" is not in: ") + text));
    // A column as on the screen, for every participant, and what it means once.
    QCOMPARE(text.count(QStringLiteral("How much of the result comes from the prior")), 1);
    QVERIFY2(
        QRegularExpression(
            QStringLiteral("ALPHA (! )?[\\d.]+ % [\\d.]+ . [\\d.]+ % [\\d.]+ N/m [\\d.]+ % \\d+ Completed "))
            .match(text)
            .hasMatch(),
        qPrintable(text.mid(text.indexOf(QStringLiteral("JND at the reference")), 900)));
    QVERIFY2(text.contains(QStringLiteral("Median 4.5, interquartile range 4.25 to 4.75")),
             qPrintable(text)); // as the scale has it, without noughts
    QVERIFY(report(study, file("study_de.pdf"), "de"));
    QVERIFY(textOf(file("study_de.pdf")).contains(QStringLiteral("Steifigkeit fühlen")));
    // Whoever copies from it gets the text that is seen.
    auto connection = m_site.database->openReader();
    database::StudyReader reader(**connection, database::Actor::simulated());
    for (const auto& [name, language] : {std::pair{"study.pdf", "en"}, {"study_de.pdf", "de"}}) {
        tests::PaintedPages pages;
        QVERIFY(session_report::paintStudyReport(pages, reader, study, theme(), language));
        QVERIFY(tests::wordsIn(pages.shapes()).size() > 100);
        const QStringList lost = tests::notCopied(pages.shapes(), file(name));
        QVERIFY2(lost.isEmpty(), qPrintable(lost.join(QLatin1Char('\n'))));
    }
}

void TestStudyReport::blindUntilUnblinded() {
    std::string sha256;
    const auto study = done(designOf("jnd_blind", true), sha256);
    auto connection = m_site.database->openReader();
    const auto sealed =
        database::StudyReader(**connection, database::Actor::simulated()).conditionCodes(study);
    QVERIFY(sealed && sealed->size() == 1);
    QVERIFY(report(study, file("blind.pdf")));
    const QString blind = textOf(file("blind.pdf"));
    QVERIFY(blind.contains(QString::fromStdString(sealed->front().sealedCode)) &&
            blind.contains(QString::fromStdString(sha256)));
    for (const char* told : {"Softwood", "150 N/m", "JND at"})
        QVERIFY2(!blind.contains(QLatin1String(told)), qPrintable(blind));
    QVERIFY(write([&](database::StudyRepository& all) { return all.unblindStudy(study, "all are done"); }));
    QVERIFY(report(study, file("unblinded.pdf")));
    QVERIFY(textOf(file("unblinded.pdf")).contains(QStringLiteral("Softwood tube")));
}

/// Conditions that differ: nothing of them but their codes, and how well trials went by participant, until
/// the study is unblinded.
void TestStudyReport::blindToUnlikeConditions() {
    psychophysics::StudyDesign design = designOf("jnd_unlike", true);
    psychophysics::Condition other = design.conditions.front();
    other.id = "weighty";
    other.title = {{"en", "Leaden tube"}};
    other.stimulus = testing::stimulusOf(psychophysics::Attribute::mass);
    other.stimulus.reference = 0.06;
    other.stimulus.differences.pop_back();
    other.procedures = {testing::rank3(other.stimulus.differences, 24, 12)};
    design.conditions.push_back(other);
    std::string sha256;
    const auto study = done(design, sha256);
    auto connection = m_site.database->openReader();
    const auto sealed =
        database::StudyReader(**connection, database::Actor::simulated()).conditionCodes(study);
    QVERIFY(sealed && sealed->size() == 2);
    QVERIFY(report(study, file("unlike.pdf")));
    const QString blind = textOf(file("unlike.pdf"));
    const QStringList known{"Softwood", "Leaden", "150 N/m", "60.0 g", "Kendall"};
    for (const database::SealedCondition& each : *sealed)
        QVERIFY2(blind.contains(QString::fromStdString(each.sealedCode)), qPrintable(blind));
    for (const QString& told : known)
        QVERIFY2(!blind.contains(told), qPrintable(told));
    QVERIFY2(blind.contains(QStringLiteral("stay sealed until the study is unblinded")), qPrintable(blind));
    QVERIFY2(blind.contains(QStringLiteral("2 of 2")) &&
                 blind.contains(QStringLiteral("Over all conditions together")),
             qPrintable(blind)); // quality, by participant
    for (const char* counted : {"Choices reproduced", "Weber fraction", "Practice"})
        QVERIFY2(!blind.contains(QLatin1String(counted)), counted);
    QVERIFY(write([&](database::StudyRepository& all) { return all.unblindStudy(study, "all are done"); }));
    QVERIFY(report(study, file("unlike_open.pdf")));
    const QString open = textOf(file("unlike_open.pdf"));
    for (const QString& told : known)
        QVERIFY2(open.contains(told), qPrintable(told + ": " + open));
}

/// A study of the apex: bias, sd and error instead of Weber fractions; while blind without millimetres, which
/// would tell the radius.
void TestStudyReport::tellsOfMarks() {
    psychophysics::StudyDesign design = designOf("apex_report", false);
    psychophysics::Condition& condition = design.conditions.front();
    condition.title = {{"en", "Hidden sphere"}};
    condition.stimulus = {psychophysics::Attribute::apex, 0.02, {0.0}, {}};
    condition.task = psychophysics::Task::adjustment;
    condition.procedures = {psychophysics::ConstantSpec{{0.0}, 6, true}};
    std::string sha256;
    QVERIFY(report(done(design, sha256), file("apex.pdf")));
    const QString text = textOf(file("apex.pdf"));
    for (const char* word : {"Hidden sphere", "Bias in x", "SD in y", "Marks around the true apex",
                             "Error in locating spheres", "mm,", "ALPHA", "BRAVO", "simulated observer"})
        QVERIFY2(text.contains(QLatin1String(word)),
                 qPrintable(QLatin1String(word) + QStringLiteral(" is not in: ") + text));
    QVERIFY(!text.contains(QStringLiteral("Weber fraction of the group")));
    design.id = "apex_blind";
    design.blindExperimenter = true;
    QVERIFY(report(done(design, sha256), file("apex_blind.pdf")));
    const QString blind = textOf(file("apex_blind.pdf"));
    QVERIFY(blind.contains(QStringLiteral("Bias in x")) && !blind.contains(QStringLiteral(" mm,")));
}

QTEST_MAIN(TestStudyReport)
#include "test_study_report.moc"
