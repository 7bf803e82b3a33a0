// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/study_json.h"
#include "database/accounts/account_service.h"
#include "database/repositories/study_repository.h"
#include "psychophysics/observers/simulated_observer.h"
#include "session/study/study_analysis.h"
#include "session/study/study_runner.h"
#include "session/study/study_store.h"
#include "support/session_fixture.h"
#include "support/study_designs.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace chiron;

namespace {

constexpr const char* kPassword = "a long password for tests";

/// A frozen study of one condition, and who runs it.
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
    explicit Site(psychophysics::StudyDesign of, bool byPeople = false) : design(std::move(of)) {
        if (byPeople)
            actor = researcher();
        study = *write([&](database::StudyRepository& studies) {
            return studies.createStudy(design.id, "A study", catalogue::studyJson(design).toStdString());
        });
        write([&](database::StudyRepository& studies) { return studies.freezeStudy(study); });
    }
    database::Actor researcher() {
        database::AccountService accounts(*fixture.database);
        if (!accounts.createFirstAdministrator("ada", kPassword, "Ada"))
            qFatal("no administrator");
        const auto ada = accounts.login("ada", kPassword);
        if (!accounts.createPerson(
                *ada, {"rhea", "Rhea", database::RoleSet{database::Role::researcher}, kPassword, false}))
            qFatal("no researcher");
        return *accounts.login("rhea", kPassword);
    }
    std::string enrol(const std::string& observer) {
        const auto who = *write([&](database::StudyRepository& studies) {
            return studies.enrolParticipant(study, observer.empty() ? "somebody" : "", 0, observer);
        });
        if (observer.empty())
            write([&](database::StudyRepository& studies) {
                return studies.recordConsent(
                    who.id, catalogue::studySha256(QByteArray::fromStdString(design.consent.at("en"))));
            });
        return who.code;
    }
    session::StudyRunRequest request(const std::string& code, bool quick) const {
        session::StudyRunRequest request;
        request.study = study;
        request.participantCode = code;
        request.observer = {.weber = 0.12, .lapse = 0.02};
        request.quick = quick;
        return request;
    }
    auto run(const session::StudyRunRequest& request) {
        return session::runStudyHeadless(*fixture.database, actor, request);
    }

    tests::SessionFixture fixture;
    database::Actor actor = database::Actor::simulated();
    psychophysics::StudyDesign design;
    database::StudyNumber study = 0;
};

constexpr const char* kObserver = "weber:0.12,lapse:0.02";

/// A person's run, of answers that were given somewhere.
void addRun(Site& site, const std::string& code, std::uint64_t seed) {
    const auto opened = session::openStudy(*site.fixture.database, site.actor, site.study, code);
    auto progress = session::StudyProgress::begin(site.design, "main", seed);
    if (!opened || !progress)
        qFatal("no run");
    const auto run = session::beginRun(*site.fixture.database, site.actor, *opened, "main", seed,
                                       progress->procedureIds());
    if (!run)
        qFatal("%s", run.error().message.c_str());
    psychophysics::SimulatedObserver observer({.weber = 0.12, .lapse = 0.02}, seed);
    while (!progress->done()) {
        std::vector<double> felt;
        for (const double value : progress->next().values)
            felt.push_back(std::log10(value));
        session::StudyAnswer answer;
        answer.answer = observer.answer(psychophysics::Task::rank3, felt);
        auto trial = progress->record(answer);
        trial->run = *run;
        if (!session::storeTrial(*site.fixture.database, site.actor, *trial))
            qFatal("not stored");
    }
    if (!session::finishRun(*site.fixture.database, site.actor, *opened, *run))
        qFatal("not finished");
}

bool warns(const psychophysics::GroupEstimate& group, const std::string& token) {
    return std::any_of(group.warnings.begin(), group.warnings.end(),
                       [&](const psychophysics::Warning& each) { return warningToken(each.kind) == token; });
}

} // namespace

class TestStudyRunner : public QObject {
    Q_OBJECT
private slots:
    void onlyTheSimulatedParticipantThatWasEnrolledIsRun() {
        Site site(testing::rank3Study(psychophysics::Attribute::stiffness, 12, 12), true);
        const std::string code = site.enrol(kObserver);
        const std::string person = site.enrol("");
        QCOMPARE(site.run(site.request(person, true)).error().code, core::ErrorCode::wrongUse);
        auto other = site.request(code, true);
        other.observer.weber = 0.2;
        QCOMPARE(site.run(other).error().code, core::ErrorCode::wrongUse);
        auto first = site.request(code, true);
        first.trialsAtMost = 3;
        const auto begun = site.run(first);
        QVERIFY2(begun, begun ? "" : begun.error().message.c_str());
        QVERIFY(!begun->completed);
        QCOMPARE(site.run(site.request(code, false)).error().code,
                 core::ErrorCode::wrongUse); // begun without a rendering
        const auto ended = site.run(site.request(code, true));
        QVERIFY(ended);
        QVERIFY(ended->completed);
        QCOMPARE(ended->runs.front().scored, 12);
    }
    void onlyAConditionThatIsOpenIsRun() {
        psychophysics::StudyDesign design = testing::rank3Study(psychophysics::Attribute::stiffness, 12, 12);
        design.conditions.push_back(design.conditions.front());
        design.conditions.back().id = "other";
        Site site(design);
        auto asked = site.request(site.enrol(kObserver), true);
        asked.condition = "main";
        QVERIFY(site.run(asked));
        const auto again = site.run(asked);
        QVERIFY(!again && again.error().code == core::ErrorCode::wrongUse);
        QVERIFY2(again.error().message.find("main is completed") != std::string::npos,
                 again.error().message.c_str());
        asked.condition = "nowhere";
        const auto unknown = site.run(asked);
        QVERIFY(!unknown);
        QVERIFY2(unknown.error().message.find("nowhere") != std::string::npos,
                 unknown.error().message.c_str());
        asked.condition.clear(); // whatever is open
        const auto rest = site.run(asked);
        QVERIFY(rest && rest->completed && rest->runs.size() == 1);
        QCOMPARE(rest->runs.front().condition, std::string("other"));
    }
    void anotherVersionNeverGoesOn() {
        Site site(testing::rank3Study(psychophysics::Attribute::stiffness, 12, 12), true);
        const std::string code = site.enrol(kObserver);
        const auto opened = session::openStudy(*site.fixture.database, site.actor, site.study, code);
        QVERIFY(opened && session::beginRun(*site.fixture.database, site.actor, *opened, "main", 1,
                                            "rank3_quest_plus@0"));
        const auto refused = site.run(site.request(code, true));
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, core::ErrorCode::wrongUse);
        QVERIFY2(refused.error().message.find("another version") != std::string::npos,
                 refused.error().message.c_str());
    }
    void blindedSessionsBearTheSealedCode() {
        auto design = testing::rank3Study();
        design.blindExperimenter = true;
        Site site(design);
        const std::string code = site.enrol(kObserver);
        auto request = site.request(code, false);
        request.trialsAtMost = 1;
        const auto report = site.run(request);
        QVERIFY2(report, report ? "" : report.error().message.c_str());
        const auto opened = session::openStudy(*site.fixture.database, site.actor, site.study, code);
        QVERIFY(opened);
        const std::string sealed = opened->runs.front().sealedCode;
        QVERIFY(!sealed.empty());
        auto connection = site.fixture.database->openReader();
        const auto id = report->runs.front().session;
        const auto closed = session::SessionView::open(**connection, site.actor, id);
        QVERIFY(!closed && closed.error().code == core::ErrorCode::notAllowed); // to whom it belongs, too
        const auto stored = session::SessionView::open(**connection, database::Actor::maintenance(), id);
        QVERIFY(stored);
        const QJsonObject level =
            QJsonDocument::fromJson(QByteArray::fromStdString((*stored)->record().setup.contentJson))
                .object()["level"]
                .toObject();
        QCOMPARE(level["id"].toString().toStdString(), sealed);
        QCOMPARE(level["title"]["en"].toString().toStdString(), design.id + " / " + sealed);
    }
    /// A run that gave up stays open: it is not sealed as completed, and another sitting goes on with it.
    void aRunThatGaveUpIsNotCompleted() {
        auto design = testing::rank3Study();
        design.fidelity.repeatsAtMost = 2;
        Site site(design);
        const std::string code = site.enrol(kObserver);
        auto request = site.request(code, false);
        request.control = simulation::ComparisonControl::gain;
        for (int sitting = 1; sitting <= 2; ++sitting) {
            const auto report = site.run(request);
            QVERIFY2(report, report ? "" : report.error().message.c_str());
            QVERIFY(!report->completed && !report->runs.front().completed);
            QCOMPARE(report->runs.front().scored, 0);
            QCOMPARE(report->runs.front().spoiled, 2 * sitting);
            const auto opened = session::openStudy(*site.fixture.database, site.actor, site.study, code);
            QCOMPARE(opened->runs.front().state, database::StudyRunState::open);
        }
    }
    /// The device's delay is measured before a run, and what it would make tremble is not in the run's table.
    void theMeasuredDelayLimitsTheTable() {
        psychophysics::StudyDesign design = testing::rank3Study(psychophysics::Attribute::stiffness, 6, 6);
        design.conditions.front().stimulus.reference = 2000.0;
        Site site(design);
        const std::string code = site.enrol(kObserver);
        const auto quick = site.run(site.request(site.enrol(kObserver), true));
        QVERIFY(quick && !quick->limits); // nothing renders it
        auto request = site.request(code, false);
        request.trialsAtMost = 1;
        const auto report = site.run(request);
        QVERIFY2(report, report ? "" : report.error().message.c_str());
        QVERIFY(report->limits->measured);
        QVERIFY(report->limits->delay_s > 0.0001 &&
                report->limits->delay_s < 0.0003); // of 0.3 ms of lag, less half a step of its integration
        const double cap = report->limits->largestStiffness_N_per_m;
        const auto opened = session::openStudy(*site.fixture.database, site.actor, site.study, code);
        const double limit = session::StudyProgress::limitOf(opened->runs.front().procedures);
        QVERIFY(2000.0 * std::pow(10.0, 2.0 * limit) <= cap); // the third object is two differences away
        QVERIFY(limit < design.conditions.front().stimulus.differences.back());
        design.conditions.front().stimulus.reference =
            3500.0; // without delay the gimbal would render up to 4000 N/m
        Site stiffer(design);
        const auto refused = stiffer.run(stiffer.request(stiffer.enrol(kObserver), false));
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, core::ErrorCode::badInput);
    }
    void theGroupIsOfPeopleWhoTakePart() {
        Site site(testing::rank3Study(psychophysics::Attribute::stiffness, 20, 20), true);
        QVERIFY(site.run(site.request(site.enrol(kObserver), true)));
        const auto analyse = [&] {
            auto connection = site.fixture.database->openReader();
            database::StudyReader reader(**connection, site.actor);
            return session::analyseStudy(reader, site.study, 1);
        };
        using psychophysics::WarningKind;
        const auto counted = [](const session::AnalysedCondition& condition, WarningKind kind) {
            for (const psychophysics::Warning& each : condition.group.warnings)
                if (each.kind == kind)
                    return each.count;
            return 0;
        };
        const auto simulated = analyse();
        QVERIFY(simulated);
        QVERIFY(simulated->conditions.front().runs.front().pooled);
        QCOMPARE(counted(simulated->conditions.front(), WarningKind::notRenderedOfGroup), 1);
        for (const WarningKind nobody : {WarningKind::withdrawn, WarningKind::simulatedLeftOut,
                                         WarningKind::shownLeftOut, WarningKind::shownInGroup})
            QVERIFY(!psychophysics::hasWarning(simulated->conditions.front().group.warnings, nobody));
        QVERIFY(warns(simulated->conditions.front().group, "simulated"));
        QCOMPARE(simulated->conditions.front().group.members.size(), std::size_t{1});
        std::string gone;
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            gone = site.enrol("");
            addRun(site, gone, seed);
        }
        const auto who =
            session::openStudy(*site.fixture.database, site.actor, site.study, gone)->participant;
        site.write(
            [&](database::StudyRepository& studies) { return studies.withdrawParticipant(who.id, false); });
        const auto people = analyse();
        QVERIFY(people);
        const auto& condition = people->conditions.front();
        QVERIFY(condition.runs.size() >= 4); // all that have trials are still shown
        QCOMPARE(condition.group.members.size(), std::size_t{3});
        for (const auto& member : condition.group.members) {
            const auto& participant = condition.runs[static_cast<std::size_t>(member.index)].participant;
            QVERIFY(!participant.simulated && participant.code != gone);
        }
        QVERIFY(warns(condition.group, "simulated_left_out"));
        QCOMPARE(counted(condition, WarningKind::simulatedLeftOut), 1);
        QCOMPARE(counted(condition, WarningKind::withdrawn), 1);
        for (const WarningKind nobody :
             {WarningKind::notRenderedOfGroup, WarningKind::shownLeftOut, WarningKind::shownInGroup})
            QVERIFY(!psychophysics::hasWarning(condition.group.warnings, nobody));
        for (const session::AnalysedRun& run : condition.runs) {
            const bool left = run.participant.code == gone;
            QCOMPARE(run.pooled, !left && !run.participant.simulated);
            QCOMPARE(run.presence == session::Presence::withdrawn, left);
            QCOMPARE(run.presence == session::Presence::simulated, run.participant.simulated);
        }
    }
};

QTEST_MAIN(TestStudyRunner)
#include "test_study_runner.moc"
