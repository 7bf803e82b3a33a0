// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_site.h"

#include "database/query.h"
#include "database/repositories/score_repository.h"
#include "database/repositories/session_reader.h"
#include "database/repositories/session_repository.h"
#include "database/repositories/study_blinding.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <tuple>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// Which sealed code is which condition: nobody gets it from a list until the study is unblinded, its author
/// and administrators by an audited look, whoever conducts a run for that run.
class TestStudyBlinding : public QObject {
    Q_OBJECT
private slots:
    void init();
    void listsHoldCodesAlone();
    void authorAndAdministratorsLook();
    void aRunIsConductedByItsCode();
    void unblindingTells();
    void trialsAreKeptBack();
    void qualityIsOfAllConditions();
    void unblindingNeedsAReason();
    void reasonsOfForcesAreWithheld();
    void fixedOrderIsNotBlind();
    void oneExerciseIsBlind();
    void sittingsAreClosed();

private:
    template <class Job> auto as(const Actor& actor, Job job) {
        return m->database->write([&](WriteContext& w) {
            StudyRepository studies(w.connection(), actor);
            return job(studies);
        });
    }
    core::Result<std::vector<SealedCondition>> look(const Actor& actor) {
        return m->database->write([&](WriteContext& w) {
            return StudyReader(w.connection(), actor).sealedConditions(m_of.frozen);
        });
    }
    std::int64_t audited(const char* action) {
        auto connection = m->database->openReader();
        return selectInteger(**connection, "SELECT count(*) FROM audit WHERE action = ?",
                             {std::string(action)})
            ->value_or(0);
    }
    std::string code(const std::string& condition) {
        auto connection = m->database->openReader();
        return codeOf(**connection, m_of.frozen, condition);
    }

    std::unique_ptr<DatabaseFixture> m;
    Actor m_admin = Actor::anonymous(), m_ruth = Actor::anonymous(), m_rob = Actor::anonymous();
    StudyTargets m_of; ///< ruth's
};

void TestStudyBlinding::init() {
    m = std::make_unique<DatabaseFixture>();
    REQUIRE(m->create());
    m_admin = m->administrator().value();
    m_ruth = m->person(m_admin, "ruth", {Role::researcher}).value();
    m_rob = m->person(m_admin, "rob", {Role::researcher}).value();
    const auto made = makeStudies(*m->database, m_ruth, "blinded");
    REQUIRE(made);
    m_of = *made;
}

void TestStudyBlinding::listsHoldCodesAlone() {
    auto connection = m->database->openReader();
    for (const Actor& actor : {m_rob, m_ruth, m_admin}) { // no list tells anybody: a look is audited
        const auto codes = StudyReader(**connection, actor).conditionCodes(m_of.frozen);
        REQUIRE(codes);
        QCOMPARE(codes->size(), std::size_t{2});
        QVERIFY(codes->at(0).sealedCode < codes->at(1).sealedCode); // not the design's order
        for (const SealedCondition& each : *codes) {
            QVERIFY(each.condition.empty());
        }
        const auto runs = StudyReader(**connection, actor).runs(m_of.running);
        REQUIRE(runs);
        QVERIFY(runs->front().condition.empty());
        QCOMPARE(runs->front().sealedCode, code("hard"));
    }
}

void TestStudyBlinding::authorAndAdministratorsLook() {
    QCOMPARE(look(m_rob).error().code, core::ErrorCode::notAllowed);
    auto connection = m->database->openReader();
    QCOMPARE(StudyReader(**connection, m_ruth).sealedConditions(m_of.frozen).error().code,
             core::ErrorCode::wrongUse); // unaudited
    QCOMPARE(audited("sealedConditions"), std::int64_t{0});
    for (const Actor& actor : {m_ruth, m_admin}) {
        const auto all = look(actor);
        REQUIRE(all);
        QVERIFY(all->front().condition == "soft" && all->front().sealedCode == code("soft"));
    }
    QCOMPARE(audited("sealedConditions"), std::int64_t{2});
}

void TestStudyBlinding::aRunIsConductedByItsCode() {
    const auto conduct = [&](const Actor& actor, ParticipantNumber who, const std::string& name) {
        return as(actor, [&](StudyRepository& s) { return s.conductRun(who, name); });
    };
    for (const Actor& actor : {m_rob, m_ruth}) { // by name it would tell the code
        QCOMPARE(conduct(actor, m_of.ready, "soft").error().code, core::ErrorCode::badInput);
    }
    QCOMPARE(as(m_rob,
                [&](StudyRepository& s) {
                    return s.beginRun({m_of.ready, "soft", 0, 1, "descending@1"});
                })
                 .error()
                 .code,
             core::ErrorCode::badInput);
    QCOMPARE(conduct(m_rob, m_of.enrolled, code("soft")).error().code,
             core::ErrorCode::wrongUse); // no consent, no run, no look
    QCOMPARE(audited("conductRun"), std::int64_t{0});
    const auto fresh = conduct(m_rob, m_of.ready, code("soft"));
    REQUIRE(fresh);
    QVERIFY(fresh->condition == "soft" && !fresh->open);
    const auto open = conduct(m_rob, m_of.running, code("hard"));
    REQUIRE(open);
    QVERIFY(open->condition == "hard" && open->open && open->open->id == m_of.run &&
            open->trials.size() == 1);
    QCOMPARE(audited("conductRun"), std::int64_t{2});
    REQUIRE(as(m_rob, [&](StudyRepository& s) {
        return s.beginRun({m_of.ready, code("soft"), 0, 1, "descending@1"});
    }));
    REQUIRE(as(m_rob, [&](StudyRepository& s) { return s.finishRun(m_of.run, StudyRunState::completed); }));
    QCOMPARE(conduct(m_rob, m_of.running, code("hard")).error().code,
             core::ErrorCode::wrongUse); // done: nothing to conduct
}

void TestStudyBlinding::unblindingTells() {
    QCOMPARE(as(m_rob, [&](StudyRepository& s) { return s.unblindStudy(m_of.frozen, "all are done"); })
                 .error()
                 .code,
             core::ErrorCode::notAllowed);
    REQUIRE(as(m_ruth, [&](StudyRepository& s) { return s.unblindStudy(m_of.frozen, "all are done"); }));
    auto connection = m->database->openReader();
    QCOMPARE(StudyReader(**connection, m_rob).runs(m_of.running)->front().condition, std::string("hard"));
    const auto codes = StudyReader(**connection, m_rob).conditionCodes(m_of.frozen);
    REQUIRE(codes);
    for (const SealedCondition& each : *codes) {
        QCOMPARE(each.sealedCode, code(each.condition));
    }
    QCOMPARE(audited("unblindStudy"), std::int64_t{1});
}

// Soft and hard differ in their reference: whatever a run left behind, its length too, could tell which it
// is.
void TestStudyBlinding::trialsAreKeptBack() {
    StudyTrial trial = someTrial(m_of.run, 1);
    trial.fidelityJson =
        R"({"contacts":3,"peak_force_N":2.5,"places":[{"place":0,"rendered":812.5,"contacts":1}]})";
    REQUIRE(as(m_ruth, [&](StudyRepository& s) { return s.storeStudyTrial(trial); }));
    auto connection = m->database->openReader();
    for (const Actor& actor : {m_rob, m_ruth, m_admin}) {
        const auto none = StudyReader(**connection, actor).studyTrials(m_of.run);
        QVERIFY(none && none->empty());
        const auto run = StudyReader(**connection, actor).runs(m_of.running)->front();
        QVERIFY(run.seed == 0 && run.procedures.empty());
        QCOMPARE(StudyReader(**connection, actor).study(m_of.frozen)->summary.trials,
                 0); // before a run and after it: the same
    }
    REQUIRE(as(m_ruth, [&](StudyRepository& s) { return s.unblindStudy(m_of.frozen, "all are done"); }));
    const auto all = StudyReader(**connection, m_rob).studyTrials(m_of.run);
    QVERIFY(all && all->size() == 2 && all->at(1).fidelityJson == trial.fidelityJson &&
            all->at(1).difference == 0.1 && all->at(1).answer == 3);
    QVERIFY(StudyReader(**connection, m_rob).runs(m_of.running)->front().procedures == "descending@1");
}

// Quality is watched without unsealing: what the device did at once, what depends on the objects once every
// condition is in it.
void TestStudyBlinding::qualityIsOfAllConditions() {
    auto connection = m->database->openReader();
    const auto quality = [&] {
        const auto rows = StudyReader(**connection, m_rob).trialQuality(m_of.frozen);
        for (const ParticipantQuality& each : rows.value_or(std::vector<ParticipantQuality>{})) {
            if (each.participant == m_of.running) {
                return each;
            }
        }
        return ParticipantQuality{};
    };
    const auto store = [&](StudyRunNumber run, int ordinal, const std::string& spoiled, double share,
                           double explored_s) {
        StudyTrial trial = someTrial(run, ordinal);
        trial.practice = false;
        trial.spoiled = spoiled;
        trial.exploration_s = explored_s;
        trial.fidelityJson = R"({"late_ticks":)" + std::to_string(share) + R"(,"worst_lateness_us":)" +
                             std::to_string(100 * (ordinal + 1)) + "}";
        REQUIRE(as(m_ruth, [&](StudyRepository& s) { return s.storeStudyTrial(trial); }));
    };
    store(m_of.run, 1, "", 0.01, 2.0);
    store(m_of.run, 2, "saturation", 0.03, 30.0);
    REQUIRE(as(m_ruth, [&](StudyRepository& s) { return s.finishRun(m_of.run, StudyRunState::completed); }));
    const ParticipantQuality half = quality();
    QVERIFY(!half.whole && half.conditionsDone == 1 && half.conditions == 2);
    QVERIFY(std::abs(half.lateTicks - 0.02) < 1e-12 && half.worstLateness_us == 300.0);
    QVERIFY(half.presentations == 0 && half.practice == 0 && half.scored == 0 && half.spoiled.empty() &&
            std::isnan(half.exploration_s));
    const auto second = as(m_ruth, [&](StudyRepository& s) {
        return s.beginRun({m_of.running, code("soft"), 1, 1, "descending@1"});
    });
    REQUIRE(second);
    store(*second, 0, "", 0.05, 6.0);
    store(*second, 1, "saturation", 0.07, 40.0);
    store(*second, 2, "", 0.01, 0.0); // simulated without rendering: nothing was explored
    store(*second, 3, "", 0.01, 9.0);
    QVERIFY(!quality().whole);
    REQUIRE(as(m_ruth, [&](StudyRepository& s) { return s.finishRun(*second, StudyRunState::completed); }));
    const ParticipantQuality whole = quality();
    QVERIFY(whole.whole && whole.presentations == 7 && whole.practice == 1 && whole.scored == 4);
    QVERIFY(std::abs(whole.lateTicks - 0.03) < 1e-12 && whole.worstLateness_us == 400.0);
    QVERIFY(whole.spoiled.size() == 1 && whole.spoiled[0].first == "saturation" &&
            whole.spoiled[0].second == 2);
    QCOMPARE(whole.exploration_s, 6.0); // the median of 2, 6 and 9
}

void TestStudyBlinding::unblindingNeedsAReason() {
    for (const std::string& reason : {std::string(), std::string(501, 'x')}) {
        QCOMPARE(
            as(m_ruth, [&](StudyRepository& s) { return s.unblindStudy(m_of.frozen, reason); }).error().code,
            core::ErrorCode::badInput);
    }
    QCOMPARE(audited("unblindStudy"), std::int64_t{0});
    REQUIRE(
        as(m_ruth, [&](StudyRepository& s) { return s.unblindStudy(m_of.frozen, "A \"serious\" event"); }));
    auto connection = m->database->openReader();
    const auto kept = selectText(
        **connection, "SELECT json_extract(detail_json, '$.reason') FROM audit WHERE action = 'unblindStudy'",
        {});
    QVERIFY(kept && *kept);
    QCOMPARE(**kept, std::string("A \"serious\" event"));
}

// Of the device's own faults everybody may know; of those that come of forces nobody, while the forces tell
// conditions apart.
void TestStudyBlinding::reasonsOfForcesAreWithheld() {
    Blinding blinding;
    blinding.on = true;
    blinding.oneStimulus = false;
    for (const char* reason : {"force_error", "stiffness_error", "saturation", "peak_force"}) {
        QCOMPARE(shownReason(reason, blinding), std::string("withheld"));
    }
    for (const char* reason : {"", "late_ticks", "speed", "time", "untouched", "experimenter", "stopped"}) {
        QCOMPARE(shownReason(reason, blinding), std::string(reason));
    }
    Blinding alike = blinding, open = blinding;
    alike.oneStimulus = true;
    open.on = false;
    QCOMPARE(shownReason("saturation", alike), std::string("saturation"));
    QCOMPARE(shownReason("saturation", open), std::string("saturation"));
}

void TestStudyBlinding::fixedOrderIsNotBlind() {
    const auto freeze = [&](const std::string& key, const std::string& order) {
        std::string design = someDesign(key);
        design.insert(design.size() - 1, ",\"order\":\"" + order + "\"");
        return as(m_ruth, [&](StudyRepository& s) -> core::Result<std::string> {
            const auto made = s.createStudy(key, "Order", design);
            return made ? s.freezeStudy(*made) : tl::unexpected(made.error());
        });
    };
    const auto fixed = freeze("fixed_one", "fixed");
    QVERIFY(!fixed && fixed.error().code == core::ErrorCode::badInput &&
            fixed.error().message.find("order") != std::string::npos);
    REQUIRE(freeze("mixed_one", "latin_square"));
}

void TestStudyBlinding::oneExerciseIsBlind() {
    std::string design = someDesign("two_exercises");
    const std::string stimulus =
        R"("attribute":"stiffness","reference":800,"differences":[0.02,0.05,0.1]},"task":"rank3","procedures":[{"kind":"descending","levels":[0.1,0.05,0.02]}])";
    const std::string apex =
        R"("attribute":"apex","reference":0.02,"differences":[0.1]},"task":"adjustment","procedures":[{"kind":"constant","levels":[0.1],"repeats":3}])";
    design.replace(design.find(stimulus), stimulus.size(), apex);
    const auto freeze = [&] {
        return as(m_ruth, [&](StudyRepository& s) -> core::Result<std::string> {
            const auto made = s.createStudy("two_exercises", "Two", design);
            return made ? s.freezeStudy(*made) : tl::unexpected(made.error());
        });
    };
    const auto mixed = freeze();
    QVERIFY(!mixed && mixed.error().code == core::ErrorCode::badInput);
    QVERIFY2(mixed.error().message.find("apex") != std::string::npos, mixed.error().message.c_str());
}

// Content and recording of a sitting are its condition in numbers. Before its first trial it is known by its
// title alone.
void TestStudyBlinding::sittingsAreClosed() {
    NewSession setup = someSession();
    setup.exercise = "comparison";
    setup.contentJson = R"({"level":{"id":")" + code("hard") +
                        R"(","parameters":{"value":800},"title":{"en":"blinded / )" + code("hard") +
                        R"("}}})";
    const auto begin = [&](const NewSession& of) {
        return m->database->write(
            [&](WriteContext& w) { return SessionRepository(w.connection(), m_rob).beginSession(of); });
    };
    const auto untouched = begin(setup);
    const auto other = begin(someSession());
    REQUIRE(untouched);
    REQUIRE(other);
    auto connection = m->database->openReader();
    const auto everywhere = [&](const Actor& actor, SessionId id) {
        SessionReader sessions(**connection, actor);
        std::vector<core::ErrorCode> codes;
        const auto note = [&](const auto& result) {
            codes.push_back(result ? core::ErrorCode::wrongUse : result.error().code);
        };
        note(sessions.session(id));
        note(sessions.trials(id));
        note(sessions.events(id));
        note(sessions.secondSummaries(id));
        note(sessions.openChunks(id));
        return codes;
    };
    const std::vector<core::ErrorCode> closed(5, core::ErrorCode::notAllowed),
        open(5, core::ErrorCode::wrongUse);
    for (const Actor& actor : {m_rob, m_ruth, m_admin}) {
        QVERIFY(everywhere(actor, *untouched) == closed);
        QVERIFY(everywhere(actor, *other) == open);
        QCOMPARE(ScoreRepository(**connection, actor).scores(*untouched).error().code,
                 core::ErrorCode::notFound);
        QCOMPARE(ScoreRepository(**connection, actor).scoreSeal(*untouched).error().code,
                 core::ErrorCode::notFound);
        REQUIRE(SessionReader(**connection, actor).comments(*untouched));
    }
    QVERIFY(everywhere(Actor::maintenance(), *untouched) == open);
    const auto running = SessionReader(**connection, m_admin).listUnfinished();
    REQUIRE(running);
    QVERIFY(running->front().summary.id == *untouched && running->front().setup.contentJson.empty() &&
            !running->back().setup.contentJson.empty());
    const auto held = PrivacyRepository(**connection, m_rob).exportPerson(m_rob.personId());
    REQUIRE(held);
    QVERIFY(held->sessions.size() == 2 && held->sessions[0].sealed &&
            held->sessions[0].record.setup.contentJson.empty());
    QVERIFY(!held->sessions[1].sealed && !held->sessions[1].record.setup.contentJson.empty());
    REQUIRE(as(m_rob, [&](StudyRepository& s) { return s.storeStudyTrial(someTrial(m_of.run, 1, *other)); }));
    QVERIFY(everywhere(m_rob, *other) == closed); // by its trial
    // How long a sitting took and how much was recorded tell conditions apart: no list holds it, nor when it
    // ended.
    SessionEnd end;
    end.ticks = end.frames = 4321;
    for (const SessionId id : {*untouched, *other})
        REQUIRE(m->database->write([&](WriteContext& w) {
            return SessionRepository(w.connection(), m_rob).finishSession(id, end);
        }));
    const auto open3 = begin(someSession());
    REQUIRE(open3);
    REQUIRE(m->database->write([&](WriteContext& w) {
        return SessionRepository(w.connection(), m_rob).finishSession(*open3, end);
    }));
    const auto numbers = [&](const Actor& actor, SessionId id) {
        const auto all = SessionReader(**connection, actor).listSessions();
        const auto found = std::find_if(all->begin(), all->end(),
                                        [id](const SessionSummary& each) { return each.id == id; });
        return std::tuple(found->sealed, found->ticks, found->frames, found->recordingBytes, found->chunks,
                          found->passed.has_value());
    };
    for (const Actor& actor : {m_rob, m_ruth, m_admin}) {
        for (const SessionId id : {*untouched, *other})
            QVERIFY(numbers(actor, id) == std::tuple(true, std::uint64_t{0}, std::uint64_t{0},
                                                     std::uint64_t{0}, std::uint64_t{0}, false));
        QVERIFY(std::get<0>(numbers(actor, *open3)) == false && std::get<1>(numbers(actor, *open3)) == 4321);
    }
    const auto ends = [&](SessionId id) {
        std::vector<std::string> times;
        const auto mine = PrivacyRepository(**connection, m_rob).exportPerson(m_rob.personId());
        for (const AuditEntry& entry : mine.value().audit)
            if (entry.target == "session" && entry.targetId == id && entry.action == "finishSession")
                times.push_back(entry.utc);
        return times;
    };
    QVERIFY(ends(*untouched) == std::vector<std::string>{""} && ends(*other) == std::vector<std::string>{""});
    QVERIFY(ends(*open3).size() == 1 && !ends(*open3).front().empty());
    REQUIRE(as(m_ruth, [&](StudyRepository& s) { return s.unblindStudy(m_of.frozen, "all are done"); }));
    QVERIFY(everywhere(m_rob, *untouched) == open && everywhere(m_rob, *other) == open);
    QVERIFY(std::get<1>(numbers(m_rob, *untouched)) == 4321 && !ends(*other).front().empty());
}

QTEST_GUILESS_MAIN(TestStudyBlinding)
#include "test_study_blinding.moc"
