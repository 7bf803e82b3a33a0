// SPDX-License-Identifier: GPL-3.0-or-later
// A study whose experimenters are blind, from run to export: each run is of its own condition, nobody is told which, and after
// unblinding it says what an open study would.
#include "catalogue/study_reader.h"
#include "database/repositories/study_reader.h"
#include "database/repositories/study_repository.h"
#include "session/study/study_analysis.h"
#include "session/study/study_limits.h"
#include "session/study/study_runner.h"
#include "session/study/study_store.h"
#include "session/study_export.h"
#include "support/session_fixture.h"
#include "support/study_designs.h"

#include <QDirIterator>
#include <QtTest>

#include <cmath>
#include <map>

using namespace chiron;

namespace {

/// Two conditions that differ in their reference alone.
psychophysics::StudyDesign twoConditions(const std::string& id, bool blind) {
    psychophysics::StudyDesign design = testing::rank3Study(psychophysics::Attribute::stiffness, 20, 10, 0.0);
    design.id = id;
    design.title = {{"en", "Two"}};
    design.objective = {{"en", "Whether it holds."}};
    psychophysics::Condition& downy = design.conditions.front();
    downy.id = "downy";
    downy.title = {{"en", "Thistledown"}};
    psychophysics::Condition craggy = downy;
    craggy.id = "craggy";
    craggy.title = {{"en", "Cliffside"}};
    craggy.stimulus.reference = 437.5;
    design.conditions.push_back(craggy);
    design.order = psychophysics::OrderDesign::latinSquare;
    design.blindExperimenter = blind;
    return design;
}

struct Site {
    template <class Job> auto write(Job job) {
        auto done = fixture.database->write([&](database::WriteContext& context) {
            database::StudyRepository studies(context.connection(), actor);
            return job(studies);
        });
        if (!done)
            qFatal("%s", done.error().message.c_str());
        return done;
    }
    database::StudyNumber add(const psychophysics::StudyDesign& design) {
        const auto study = *write([&](database::StudyRepository& all) { return all.createStudy(design.id, "Two", catalogue::studyJson(design).toStdString()); });
        write([&](database::StudyRepository& all) { return all.freezeStudy(study); });
        return study;
    }
    void enrol(database::StudyNumber study, const std::string& code) {
        write([&](database::StudyRepository& all) { return all.enrolParticipant(study, "", 0, "weber:0.12,lapse:0.02", code); });
    }
    session::OpenedStudy open(database::StudyNumber study, const std::string& code) { return *session::openStudy(*fixture.database, actor, study, code); }
    session::StudyRunReport run(database::StudyNumber study, const std::string& code, const std::string& label, bool quick, int atMost) {
        session::StudyRunRequest request;
        request.study = study;
        request.participantCode = code;
        request.observer = {.weber = 0.12, .lapse = 0.02};
        request.condition = label;
        request.quick = quick;
        request.trialsAtMost = atMost;
        auto report = session::runStudyHeadless(*fixture.database, actor, request);
        if (!report)
            qFatal("%s", report.error().message.c_str());
        return *report;
    }
    /// Which code is which, as its author may look it up.
    std::map<std::string, std::string> conditionByCode(database::StudyNumber study) {
        const auto all = fixture.database->write([&](database::WriteContext& w) { return database::StudyReader(w.connection(), actor).sealedConditions(study); });
        std::map<std::string, std::string> out;
        for (const database::SealedCondition& each : *all)
            out[each.sealedCode] = each.condition;
        return out;
    }
    session::StudyAnalysis analyse(database::StudyNumber study) {
        auto connection = fixture.database->openReader();
        database::StudyReader reader(**connection, actor);
        auto analysis = session::analyseStudy(reader, study, 7);
        if (!analysis)
            qFatal("%s", analysis.error().message.c_str());
        return std::move(*analysis);
    }
    /// The same runs, trial by trial, in another study.
    void copyRuns(database::StudyNumber from, database::StudyNumber to, const std::string& code) {
        auto connection = fixture.database->openReader();
        database::StudyReader reader(**connection, actor);
        const auto who = open(to, code).participant.id;
        for (const database::StudyRun& run : open(from, code).runs) {
            const auto trials = *reader.studyTrials(run.id);
            const auto copy = *write([&](database::StudyRepository& all) { return all.beginRun({who, run.condition, run.position, run.seed, run.procedures}); });
            for (database::StudyTrial trial : trials) {
                trial.run = copy;
                write([&](database::StudyRepository& all) { return all.storeStudyTrial(trial); });
            }
            write([&](database::StudyRepository& all) { return all.finishRun(copy, database::StudyRunState::completed); });
        }
    }

    tests::SessionFixture fixture;
    database::Actor actor = database::Actor::simulated();
};

QByteArray everythingIn(const QString& folder) {
    QByteArray all;
    QDirIterator files(folder, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        all += file.fileName().toUtf8() + '\n';
        all += file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    return all;
}

bool agree(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

} // namespace

class TestBlindedStudy : public QObject {
    Q_OBJECT
private slots:
    /// Rendered and resumed by its code, each run is of the condition that the code stands for, and makes its choices again from the log.
    void runsAndResumesItsOwnCondition() {
        Site site;
        const auto study = site.add(twoConditions("sealed_runs", true));
        site.enrol(study, "S01");
        const auto conditions = site.conditionByCode(study);
        const auto opened = site.open(study, "S01");
        QCOMPARE(opened.order.size(), std::size_t{2});
        std::vector<double> references;
        for (const std::string& code : opened.order) {
            QVERIFY(conditions.contains(code));
            for (int sitting = 0; sitting < 2; ++sitting) {
                const auto report = site.run(study, "S01", code, false, 2);
                QCOMPARE(report.runs.front().condition, code);
                auto connection = site.fixture.database->openReader();
                const auto stored = session::StoredSession::open(**connection, database::Actor::maintenance(), report.runs.front().session);
                QVERIFY(stored);
                const auto& parameters = std::get<simulation::ComparisonParameters>((*stored)->setup().level.parameters);
                QCOMPARE(parameters.values.front()[0], conditions.at(code) == "downy" ? 150.0 : 437.5);
                references.push_back(parameters.values.front()[0]);
            }
        }
        QVERIFY(references.front() != references.back());
        for (const bool unblinded : {false, true}) {
            if (unblinded)
                site.write([&](database::StudyRepository& all) { return all.unblindStudy(study); });
            const auto analysis = site.analyse(study);
            for (const session::AnalysedCondition& condition : analysis.conditions) {
                QCOMPARE(condition.runs.size(), std::size_t{1});
                const session::AnalysedRun& run = condition.runs.front();
                QCOMPARE(run.trials.size(), std::size_t{4});
                QVERIFY(run.replayed.sameProcedures && run.replayed.trials == 4 && run.replayed.same + run.replayed.ties == 4);
                QCOMPARE(run.run.condition, unblinded ? condition.condition : std::string());
                QCOMPARE(conditions.at(run.run.sealedCode), unblinded ? condition.condition : conditions.at(condition.condition));
            }
        }
    }
    /// After unblinding every number is what the same runs say in a study that never was blind; before, all but physical units.
    void analysesAgreeWithAnOpenStudy() {
        Site site;
        const auto blind = site.add(twoConditions("blind_one", true));
        const auto open = site.add(twoConditions("open_one", false));
        for (const char* code : {"S01", "S02", "S03"}) {
            site.enrol(blind, code);
            site.enrol(open, code);
            QVERIFY(site.run(blind, code, {}, true, 0).completed);
        }
        const auto conditions = site.conditionByCode(blind);
        const auto before = site.analyse(blind);
        site.write([&](database::StudyRepository& all) { return all.unblindStudy(blind); });
        for (const char* code : {"S01", "S02", "S03"})
            site.copyRuns(blind, open, code);
        const auto after = site.analyse(blind), reference = site.analyse(open);
        QVERIFY(before.blind() && !after.blind() && !reference.blind());
        QCOMPARE(after.conditions.size(), std::size_t{2});
        for (std::size_t i = 0; i < after.conditions.size(); ++i) {
            const auto& mine = after.conditions[i];
            const auto& theirs = reference.conditions[i];
            QCOMPARE(mine.condition, theirs.condition);
            QVERIFY(std::isfinite(mine.group.weber) && std::isfinite(mine.group.jnd));
            QCOMPARE(mine.group.weber, theirs.group.weber);
            QCOMPARE(mine.group.jnd, theirs.group.jnd);
            QCOMPARE(mine.group.weber95.low, theirs.group.weber95.low);
            QCOMPARE(mine.ranking.tau, theirs.ranking.tau);
            QCOMPARE(mine.runs.size(), std::size_t{3});
            const auto sealed = std::find_if(before.conditions.begin(), before.conditions.end(), [&](const auto& each) { return conditions.at(each.condition) == mine.condition; });
            QVERIFY(sealed != before.conditions.end());
            QCOMPARE(sealed->group.weber, mine.group.weber);
            for (std::size_t run = 0; run < mine.runs.size(); ++run) {
                QCOMPARE(mine.runs[run].estimate.jnd, theirs.runs[run].estimate.jnd);
                QVERIFY(agree(mine.runs[run].estimate.weber95.high, theirs.runs[run].estimate.weber95.high));
                QCOMPARE(sealed->runs[run].estimate.weber, mine.runs[run].estimate.weber);
                QVERIFY(std::isnan(sealed->runs[run].estimate.jnd) && sealed->runs[run].estimate.unit.empty());
            }
        }
    }
    /// No file of an export names a condition or its values, and the order of the codes is not the design's.
    void exportsTellNoCondition() {
        Site site;
        const auto study = site.add(twoConditions("sealed_export", true));
        site.enrol(study, "S01");
        QVERIFY(site.run(study, "S01", {}, true, 0).completed);
        QTemporaryDir folder;
        const auto exported = [&](const QString& name) {
            auto connection = site.fixture.database->openReader();
            database::StudyReader reader(**connection, site.actor);
            const auto csv = session::exportStudyCsv(reader, study, folder.filePath(name + "_csv").toStdString());
            const auto bids = session::exportStudyBids(reader, **connection, site.actor, study, folder.filePath(name + "_bids").toStdString());
            return csv && bids ? everythingIn(folder.filePath(name + "_csv")) + everythingIn(folder.filePath(name + "_bids")) : QByteArray();
        };
        const QByteArray blind = exported("blind");
        for (const auto& [code, condition] : site.conditionByCode(study)) {
            QVERIFY(blind.contains(code.c_str()));
            QVERIFY(!blind.contains(condition.c_str()));
        }
        for (const char* told : {"Thistledown", "Cliffside", "437.5", "stiffness\"", "N/m"})
            QVERIFY2(!blind.contains(told), told);
        site.write([&](database::StudyRepository& all) { return all.unblindStudy(study); });
        const QByteArray open = exported("open");
        for (const char* told : {"downy", "craggy", "437.5", "N/m"})
            QVERIFY2(open.contains(told), told);
    }
    /// Forces tell hard from soft: while sealed no column of them has a number, of a rendered run neither; also where both conditions have
    /// the same stimulus, so that readers of the runs themselves may know.
    void exportsTellNoForce_data() {
        QTest::addColumn<bool>("alike");
        QTest::newRow("unlike stimuli") << false;
        QTest::newRow("one stimulus") << true;
    }
    void exportsTellNoForce() {
        QFETCH(bool, alike);
        Site site;
        auto design = twoConditions(alike ? "sealed_alike" : "sealed_forces", true);
        if (alike)
            design.conditions.back().stimulus = design.conditions.front().stimulus;
        const auto study = site.add(design);
        site.enrol(study, "S01");
        for (const std::string& code : site.open(study, "S01").order)
            QVERIFY(site.run(study, "S01", code, false, 2).runs.front().session > 0);
        QTemporaryDir folder;
        const auto columnsOf = [&](const QString& name) {
            auto connection = site.fixture.database->openReader();
            database::StudyReader reader(**connection, site.actor);
            std::map<QByteArray, QList<QByteArray>> columns;
            if (!session::exportStudyCsv(reader, study, folder.filePath(name).toStdString()))
                return columns;
            QFile file(folder.filePath(name) + "/trials.csv");
            QList<QByteArray> lines = file.open(QIODevice::ReadOnly) ? file.readAll().trimmed().split('\n') : QList<QByteArray>();
            const QList<QByteArray> names = lines.isEmpty() ? lines : lines.takeFirst().split(',');
            for (const QByteArray& line : lines)
                for (qsizetype i = 0; i < names.size(); ++i)
                    columns[names[i]] << line.split(',').value(i);
            return columns;
        };
        const auto sealed = columnsOf("sealed");
        site.write([&](database::StudyRepository& all) { return all.unblindStudy(study); });
        const auto open = columnsOf("open");
        QVERIFY(open.contains("terminal_force_1") && open.contains("peak_force_1") && open.contains("peak_force") && open.contains("rendered_1"));
        int told = 0;
        for (const auto& [name, cells] : open) {
            if (!name.contains("peak_force") && !name.contains("terminal_force") && !name.startsWith("rendered"))
                continue;
            told += static_cast<int>(std::count_if(cells.begin(), cells.end(), [](const QByteArray& cell) { return cell != "n/a"; }));
            QCOMPARE(sealed.at(name).size(), 4);
            for (const QByteArray& cell : sealed.at(name))
                QVERIFY2(cell == "n/a", (name + ": " + cell).constData());
        }
        QVERIFY(told > 8); // there was something to hide
    }
    /// What a device leaves of one condition would tell which it is: blind, all conditions have what is left of the least.
    void theDeviceLimitIsShared() {
        const auto design = twoConditions("limits", true);
        session::RenderingLimits limits;
        limits.largestStiffness_N_per_m = 800.0;
        limits.largestForce_N = 4.0;
        const auto& [downy, craggy] = std::tie(design.conditions[0], design.conditions[1]);
        const double own = session::limitedTable(downy, limits).limit, least = session::limitedTable(craggy, limits).limit;
        QVERIFY(std::isfinite(least) && least < own);
        QCOMPARE(session::blindTable(design, downy, limits).limit, least);
        QCOMPARE(session::blindTable(design, craggy, limits).limit, least);
        QCOMPARE(session::blindTable(design, downy, limits).candidates, session::limitedTable(craggy, limits).candidates);
    }
    void errorsGoByCode() {
        session::OpenedStudy study;
        study.design = twoConditions("errors", true);
        study.record.blinding.on = true;
        const database::ConductedRun run{"craggy", "Q7M", {}, {}, {}};
        const core::Error error{core::ErrorCode::badInput, "condition \"craggy\": the device renders none of craggy"};
        QCOMPARE(session::sealedError(study, run, error).message, std::string("condition \"Q7M\": the device renders none of Q7M"));
        study.record.blinding.on = false; // unblinded
        QCOMPARE(session::sealedError(study, run, error).message, error.message);
    }
};

QTEST_GUILESS_MAIN(TestBlindedStudy)
#include "test_blinded_study.moc"
