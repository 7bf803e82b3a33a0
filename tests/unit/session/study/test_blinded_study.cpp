// SPDX-License-Identifier: GPL-3.0-or-later
// A study whose experimenters are blind, from run to export: each run is of its own condition, nobody is told
// which, and after unblinding it says what an open study would.
#include "catalogue/study_json.h"
#include "database/repositories/study_reader.h"
#include "database/repositories/study_repository.h"
#include "session/study/study_analysis.h"
#include "session/study/study_limits.h"
#include "session/study/study_runner.h"
#include "session/study/study_store.h"
#include "session/study_export.h"
#include "support/session_fixture.h"
#include "support/study_designs.h"

#include <QDir>
#include <QDirIterator>
#include <QFileInfo>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

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
        const auto study = *write([&](database::StudyRepository& all) {
            return all.createStudy(design.id, "Two", catalogue::studyJson(design).toStdString());
        });
        write([&](database::StudyRepository& all) { return all.freezeStudy(study); });
        return study;
    }
    void enrol(database::StudyNumber study, const std::string& code) {
        write([&](database::StudyRepository& all) {
            return all.enrolParticipant(study, "", 0, "weber:0.12,lapse:0.02", code);
        });
    }
    session::OpenedStudy open(database::StudyNumber study, const std::string& code) {
        return *session::openStudy(*fixture.database, actor, study, code);
    }
    session::StudyRunReport run(database::StudyNumber study, const std::string& code,
                                const std::string& label, bool quick, int atMost) {
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
        const auto all = fixture.database->write([&](database::WriteContext& w) {
            return database::StudyReader(w.connection(), actor).sealedConditions(study);
        });
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
    /// A completed run in which everything that can tell conditions apart does: times, speeds, contacts,
    /// forces, numbers of trials, answers.
    void addTellingRun(database::ParticipantNumber who, const std::string& label, bool hard,
                       int participant) {
        const auto run = *write([&](database::StudyRepository& all) {
            return all.beginRun({who, label, 0, 7, "rank3_quest_plus@1"});
        });
        const int trials = hard ? 22 : 12;
        for (int i = 0; i < trials; ++i) {
            database::StudyTrial trial;
            trial.run = run;
            trial.ordinal = i;
            trial.firstTick = static_cast<std::uint64_t>(i) * 20000;
            trial.lastTick = trial.firstTick + (hard ? 9000 : 5000);
            trial.candidate = hard ? 5 : 20;
            trial.arrangement = i % 6;
            trial.difference = hard ? 0.02 : 0.1;
            trial.answer = (i + (hard && i % 3 == 0 ? 1 : 0)) % 6;
            trial.outcome = hard && i % 3 == 0 ? 1 : 0;
            trial.exploration_s = (hard ? 9.0 : 5.0) + 0.1 * ((i * 7 + participant) % 10);
            trial.answer_s = (hard ? 1.5 : 0.6) + 0.01 * ((i * 3 + participant) % 10);
            trial.spoiled = hard && i % 5 == 4 ? "saturation" : "";
            trial.fidelityJson =
                std::string(R"({"contacts":)") + (hard ? "9" : "4") + R"(,"duration_s":)" +
                (hard ? "9.5" : "5.5") + R"(,"late_ticks":0.0)" +
                std::to_string((i * 11 + 3 * participant) % 7) + R"(,"mean_speed_m_per_s":)" +
                (hard ? "0.02" : "0.05") + R"(,"measured":true,"outside":"",)" +
                R"("paused_s":0,"peak_force_N":)" + (hard ? "2.9" : "1.1") + R"(,"places":[],"saturated":)" +
                (hard ? "0.02" : "0") + R"(,"shown":false,"stiffness_error":0.03,"worst_lateness_us":180})";
            write([&](database::StudyRepository& all) { return all.storeStudyTrial(trial); });
        }
        write([&](database::StudyRepository& all) {
            return all.finishRun(run, database::StudyRunState::completed);
        });
    }
    /// The same runs, trial by trial, in another study.
    void copyRuns(database::StudyNumber from, database::StudyNumber to, const std::string& code) {
        auto connection = fixture.database->openReader();
        database::StudyReader reader(**connection, actor);
        const auto who = open(to, code).participant.id;
        for (const database::StudyRun& run : open(from, code).runs) {
            const auto trials = *reader.studyTrials(run.id);
            const auto copy = *write([&](database::StudyRepository& all) {
                return all.beginRun({who, run.condition, run.position, run.seed, run.procedures});
            });
            for (database::StudyTrial trial : trials) {
                trial.run = copy;
                write([&](database::StudyRepository& all) { return all.storeStudyTrial(trial); });
            }
            write([&](database::StudyRepository& all) {
                return all.finishRun(copy, database::StudyRunState::completed);
            });
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

QStringList rowsOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()).trimmed().split('\n')
                                          : QStringList();
}

/// How much better than the commonest condition a column's cells name a row's: by each cell's own majority
/// among the other rows, or by one threshold through numbers. Between 0 and 1.
double separation(const QStringList& cells, const std::vector<bool>& hard) {
    const auto all = static_cast<double>(cells.size());
    const auto hards = static_cast<double>(std::count(hard.begin(), hard.end(), true));
    const double commonest = std::max(hards, all - hards) / all;
    std::map<QString, std::pair<int, int>> counts;
    for (qsizetype i = 0; i < cells.size(); ++i)
        ++(hard[static_cast<std::size_t>(i)] ? counts[cells[i]].first : counts[cells[i]].second);
    double right = 0.0; // leave one out
    for (qsizetype i = 0; i < cells.size(); ++i) {
        auto [h, s] = counts[cells[i]];
        --(hard[static_cast<std::size_t>(i)] ? h : s);
        right += h == s ? 0.5 : (h > s) == hard[static_cast<std::size_t>(i)] ? 1.0 : 0.0;
    }
    double best = right / all;
    for (const QString& at : cells) {
        bool number = false;
        const double threshold = at.toDouble(&number);
        if (!number)
            continue;
        int above = 0, of = 0;
        for (qsizetype i = 0; i < cells.size(); ++i) {
            bool other = false;
            const double value = cells[i].toDouble(&other);
            if (!other)
                continue;
            ++of;
            above += (value > threshold) == hard[static_cast<std::size_t>(i)] ? 1 : 0;
        }
        best = std::max(best, std::max(above, of - above) / all);
    }
    return (best - commonest) / std::max(1e-9, 1.0 - commonest);
}

/// "file/column" of the tables of runs by which conditions can be told apart in more than chance.
QStringList tellingColumns(const QString& folder, const std::map<std::string, std::string>& conditionByCode) {
    constexpr double kChance = 0.4; // of the way from guessing to knowing; runs.csv has some 17 rows
    QStringList telling;
    for (const QFileInfo& file : QDir(folder).entryInfoList({"*.csv"}, QDir::Files)) {
        QStringList rows = rowsOf(file.filePath());
        const QStringList names = rows.takeFirst().split(',');
        const qsizetype label = names.indexOf("condition");
        if (label < 0 || rows.isEmpty())
            continue;
        std::vector<bool> hard;
        for (const QString& row : rows) {
            const std::string written = row.split(',')[label].toStdString();
            const auto found = conditionByCode.find(written);
            hard.push_back((found == conditionByCode.end() ? written : found->second) == "craggy");
        }
        for (qsizetype column = 0; column < names.size(); ++column) {
            QStringList cells;
            for (const QString& row : rows)
                cells << row.split(',').value(column);
            if (column != label && separation(cells, hard) > kChance)
                telling << file.fileName() + '/' + names[column];
        }
    }
    return telling;
}

bool agree(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

} // namespace

class TestBlindedStudy : public QObject {
    Q_OBJECT
private slots:
    /// Rendered and resumed by its code, each run is of the condition that the code stands for, and makes its
    /// choices again from the log.
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
                const auto stored = session::SessionView::open(**connection, database::Actor::maintenance(),
                                                               report.runs.front().session);
                QVERIFY(stored);
                const auto& parameters =
                    (*stored)->setup().level.parameters.as<simulation::ComparisonParameters>();
                QCOMPARE(parameters.values.front()[0], conditions.at(code) == "downy" ? 150.0 : 437.5);
                references.push_back(parameters.values.front()[0]);
            }
        }
        QVERIFY(references.front() != references.back());
        for (const bool unblinded : {false, true}) {
            if (unblinded)
                site.write(
                    [&](database::StudyRepository& all) { return all.unblindStudy(study, "all are done"); });
            const auto analysis = site.analyse(study);
            for (const session::AnalysedCondition& condition : analysis.conditions) {
                QCOMPARE(condition.runs.size(), std::size_t{1});
                const session::AnalysedRun& run = condition.runs.front();
                QCOMPARE(
                    run.trials.size(),
                    std::size_t{unblinded ? 4u : 0u}); // how many there were may tell which condition it is
                QVERIFY(!unblinded || (run.replayed.sameProcedures && run.replayed.trials == 4 &&
                                       run.replayed.same + run.replayed.ties == 4));
                QCOMPARE(run.run.condition, unblinded ? condition.condition : std::string());
                QCOMPARE(conditions.at(run.run.sealedCode),
                         unblinded ? condition.condition : conditions.at(condition.condition));
            }
        }
    }
    /// After unblinding every number is what the same runs say in a study that never was blind; before, there
    /// is none.
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
        site.write([&](database::StudyRepository& all) { return all.unblindStudy(blind, "all are done"); });
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
            const auto sealed =
                std::find_if(before.conditions.begin(), before.conditions.end(), [&](const auto& each) {
                    return conditions.at(each.condition) == mine.condition;
                });
            QVERIFY(sealed != before.conditions.end());
            QVERIFY(std::isnan(sealed->group.weber));
            for (std::size_t run = 0; run < mine.runs.size(); ++run) {
                QCOMPARE(mine.runs[run].estimate.jnd, theirs.runs[run].estimate.jnd);
                QVERIFY(agree(mine.runs[run].estimate.weber95.high, theirs.runs[run].estimate.weber95.high));
                const auto& closed = sealed->runs[run];
                QVERIFY(std::isnan(closed.estimate.weber) && std::isnan(closed.estimate.jnd) &&
                        closed.estimate.unit.empty() && closed.estimate.points.empty());
                QVERIFY(closed.trials.empty() && closed.scored == 0 && closed.spoiled == 0 &&
                        closed.practice == 0 && closed.replayed.trials == 0);
                QVERIFY(
                    psychophysics::hasWarning(closed.estimate.warnings, psychophysics::WarningKind::sealed));
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
            const auto csv =
                session::exportStudyCsv(reader, study, folder.filePath(name + "_csv").toStdString());
            const auto bids = session::exportStudyBids(reader, **connection, site.actor, study,
                                                       folder.filePath(name + "_bids").toStdString());
            return csv && bids ? everythingIn(folder.filePath(name + "_csv")) +
                                     everythingIn(folder.filePath(name + "_bids"))
                               : QByteArray();
        };
        const QByteArray blind = exported("blind");
        for (const auto& [code, condition] : site.conditionByCode(study)) {
            QVERIFY(blind.contains(code.c_str()));
            QVERIFY(!blind.contains(condition.c_str()));
        }
        for (const char* told : {"Thistledown", "Cliffside", "437.5", "stiffness\"", "N/m"})
            QVERIFY2(!blind.contains(told), told);
        site.write([&](database::StudyRepository& all) { return all.unblindStudy(study, "all are done"); });
        const QByteArray open = exported("open");
        for (const char* told : {"downy", "craggy", "437.5", "N/m"})
            QVERIFY2(open.contains(told), told);
    }
    /// Whoever tries to tell the conditions apart by any column of an export fails while the study is
    /// blinded, though all that can differ does, and succeeds by many once it is not.
    void noColumnTellsConditionsApart() {
        Site site;
        const auto study = site.add(twoConditions("sealed_columns", true));
        const auto conditions = site.conditionByCode(study);
        constexpr int kParticipants = 10;
        for (int i = 0; i < kParticipants; ++i) {
            const std::string code = "S" + std::to_string(10 + i);
            site.enrol(study, code);
            const auto opened = site.open(study, code);
            for (std::size_t run = 0; run < (i % 3 == 2 ? 1u : 2u); ++run) // some have done one alone
                site.addTellingRun(opened.participant.id, opened.order[run],
                                   conditions.at(opened.order[run]) == "craggy", i);
        }
        QTemporaryDir folder;
        const auto exported = [&](const QString& name) {
            auto connection = site.fixture.database->openReader();
            database::StudyReader reader(**connection, site.actor);
            const auto path = folder.filePath(name);
            if (!session::exportStudyCsv(reader, study, (path + "_csv").toStdString()) ||
                !session::exportStudyBids(reader, **connection, site.actor, study,
                                          (path + "_bids").toStdString()))
                qFatal("no export");
            return path;
        };
        const QString blind = exported("blind");
        QStringList telling = tellingColumns(blind + "_csv", conditions);
        QVERIFY2(telling.isEmpty(), qPrintable(telling.join(", ")));
        QCOMPARE(rowsOf(blind + "_csv/trials.csv").size(), qsizetype{1}); // the heading alone
        const QStringList runs = rowsOf(blind + "_csv/runs.csv").mid(1);
        QStringList owners;
        for (const QString& row : runs)
            owners << row.section(',', 1, 2);
        QStringList sorted = owners;
        sorted.sort();
        QCOMPARE(owners, sorted); // by codes alone: neither enrolment nor the order of conditions shows
        QDirIterator files(blind + "_bids", {"*.tsv"}, QDir::Files, QDirIterator::Subdirectories);
        int sealedFiles = 0;
        while (files.hasNext()) {
            const QString file = files.next();
            for (const auto& [code, condition] : conditions)
                QVERIFY2(!file.contains(QString::fromStdString(code)), qPrintable(file));
            if (!file.endsWith("_beh.tsv"))
                continue;
            ++sealedFiles;
            QCOMPARE(rowsOf(file).size(), qsizetype{2}); // one line, whoever it is
        }
        QCOMPARE(sealedFiles, kParticipants);
        // Who has done one condition has no counts and no times: they would be that one's.
        for (const QString& row : rowsOf(blind + "_csv/quality.csv").mid(1))
            QCOMPARE(row.endsWith("n/a,n/a,n/a,n/a,n/a"), row.section(',', 2, 2) == "1");
        site.write([&](database::StudyRepository& all) { return all.unblindStudy(study, "all are done"); });
        telling = tellingColumns(exported("open") + "_csv", conditions);
        for (const char* column :
             {"trials.csv/exploration_time", "trials.csv/response_time", "trials.csv/contacts",
              "trials.csv/mean_speed", "trials.csv/peak_force", "trials.csv/value_1",
              "runs.csv/presentations", "runs.csv/scored", "runs.csv/reference", "estimates.csv/trials"})
            QVERIFY2(telling.contains(QLatin1String(column)), column);
    }
    /// What a device leaves of one condition would tell which it is: blind, all conditions have what is left
    /// of the least.
    void theDeviceLimitIsShared() {
        const auto design = twoConditions("limits", true);
        session::RenderingLimits limits;
        limits.largestStiffness_N_per_m = 800.0;
        limits.largestForce_N = 4.0;
        const auto& [downy, craggy] = std::tie(design.conditions[0], design.conditions[1]);
        const double own = session::limitedTable(downy, limits).limit,
                     least = session::limitedTable(craggy, limits).limit;
        QVERIFY(std::isfinite(least) && least < own);
        QCOMPARE(session::blindTable(design, downy, limits).limit, least);
        QCOMPARE(session::blindTable(design, craggy, limits).limit, least);
        QCOMPARE(session::blindTable(design, downy, limits).candidates,
                 session::limitedTable(craggy, limits).candidates);
    }
    void errorsGoByCode() {
        session::OpenedStudy study;
        study.design = twoConditions("errors", true);
        study.record.blinding.on = true;
        const database::ConductedRun run{"craggy", "Q7M", {}, {}, {}};
        const core::Error error{core::ErrorCode::badInput,
                                "condition \"craggy\": the device renders none of craggy"};
        QCOMPARE(session::sealedError(study, run, error).message,
                 std::string("condition \"Q7M\": the device renders none of Q7M"));
        study.record.blinding.on = false; // unblinded
        QCOMPARE(session::sealedError(study, run, error).message, error.message);
    }
};

QTEST_GUILESS_MAIN(TestBlindedStudy)
#include "test_blinded_study.moc"
