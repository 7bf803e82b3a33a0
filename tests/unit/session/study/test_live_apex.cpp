// SPDX-License-Identifier: GPL-3.0-or-later
// A person's sitting of the apex in real time without a window: marks by hand, a break in the middle, spoiled
// trials in a further session, stopping and going on, and the limit of the device.
#include "app/exercises/sphere_apex/session/apex_tap.h"
#include "app/exercises/sphere_apex/session/live_apex.h"
#include "catalogue/study_catalogue.h"
#include "catalogue/study_json.h"
#include "database/accounts/account_service.h"
#include "database/query.h"
#include "database/repositories/study_reader.h"
#include "database/repositories/study_repository.h"
#include "session/replayer.h"
#include "session/study/study_analysis.h"
#include "session/study/study_store.h"
#include "support/apex_marker.h"
#include "support/patience.h"
#include "support/session_fixture.h"

#include <QtTest>

using chiron::tests::kPatience_ms;

using namespace chiron;
using View = session::LiveStudyView::State;

namespace {

constexpr const char* kPassword = "a long password for tests";
constexpr double kBeside_m = 0.003;
constexpr double kNear_m = 2e-4; ///< what is shown, not felt, slows the hand down where it touches

/// The content's study with a few trials and without limits that a busy machine would pass.
psychophysics::StudyDesign design(int scored) {
    const auto content = catalogue::StudyCatalogue::load();
    if (!content)
        qFatal("%s", content.error().message.c_str());
    psychophysics::StudyDesign of = *content->find("apex");
    std::get<psychophysics::ConstantSpec>(of.conditions.front().procedures.front()).repeats = scored;
    of.trial.practiceTrials = 0;
    of.trial.betweenTrials_s = 0.1;
    of.fidelity.lateTicks = 1.0;
    of.fidelity.meanSpeed_m_per_s = 10.0;
    return of;
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
    explicit Site(psychophysics::StudyDesign of) : study_design(std::move(of)) {
        database::AccountService accounts(*fixture.database);
        if (!accounts.createFirstAdministrator("ada", kPassword, "Ada"))
            qFatal("no administrator");
        const auto ada = accounts.login("ada", kPassword);
        if (!accounts.createPerson(
                *ada, {"rhea", "Rhea", database::RoleSet{database::Role::researcher}, kPassword, false}))
            qFatal("no researcher");
        actor = *accounts.login("rhea", kPassword);
        study = *write([&](database::StudyRepository& studies) {
            return studies.createStudy(study_design.id, "Apex",
                                       catalogue::studyJson(study_design).toStdString());
        });
        write([&](database::StudyRepository& studies) { return studies.freezeStudy(study); });
        const auto who = *write([&](database::StudyRepository& studies) {
            return studies.enrolParticipant(study, "somebody", 0, {});
        });
        write([&](database::StudyRepository& studies) {
            return studies.recordConsent(
                who.id, catalogue::studySha256(QByteArray::fromStdString(study_design.consent.at("en"))));
        });
        code = who.code;
    }
    session::LiveStudyRequest request() {
        session::LiveStudyRequest asked;
        asked.study = study;
        asked.participantCode = code;
        asked.ringFolder = recording::defaultRingFolder();
        asked.nextStation = [] { return session::keyboardMouseStation(); };
        asked.station = std::move(*session::keyboardMouseStation());
        return asked;
    }
    std::unique_ptr<session::LiveSitting> sit() {
        auto live = session::LiveSitting::start(*fixture.database, actor, request());
        if (!live)
            qFatal("%s", live.error().message.c_str());
        return std::move(*live);
    }
    database::StudyRun run() {
        return session::openStudy(*fixture.database, actor, study, code)->runs.front();
    }
    std::vector<database::StudyTrial> trials() {
        auto connection = fixture.database->openReader();
        return *database::StudyReader(**connection, actor).studyTrials(run().id);
    }

    tests::SessionFixture fixture;
    database::Actor actor = database::Actor::simulated();
    psychophysics::StudyDesign study_design;
    database::StudyNumber study = 0;
    std::string code;
};

/// Touches the sphere of the trial beside its top and marks there. False where no trial came.
bool mark(session::LiveSitting& live, const std::vector<simulation::SphereApexTrial>& places) {
    const auto now = live.numbers();
    const int before = now.scored + now.spoiled;
    if (!QTest::qWaitFor([&] { return live.poll(), live.view().state == View::exploring; }, kPatience_ms))
        return false;
    const auto trial = live.training().display().latest().trial;
    const core::Vec3 to(places.at(trial).centre_m.x() + kBeside_m, places.at(trial).centre_m.y(), 0.019);
    const auto there = [&] {
        return live.poll(), live.view().canAnswer && (tests::toolOf(live) - to).norm() < kNear_m;
    };
    for (int tries = 0; tries < 100 && !there(); ++tries) { // of what touches, a part of each way is left
        tests::moveTo(live, to);
        (void)QTest::qWaitFor(there, 300);
    }
    if (!there())
        return false;
    if (!live.answer(0))
        return false;
    return QTest::qWaitFor(
        [&] { return live.poll(), live.numbers().scored + live.numbers().spoiled > before; }, kPatience_ms);
}

} // namespace

class TestLiveApex : public QObject {
    Q_OBJECT
private slots:
    void marksBecomeTrialsAndTheAnalysisSaysTheSame();
    void aSpoiledTrialComesAgainInAFurtherSession();
    void stopsAndGoesOnAtTheTrial();
    void forceIsStoppedAndRearmed();
    void aBreakHoldsTheExercise();
    void aDeviceThatIsTooSlowIsRefused();
    void lostTicksAreSaid();
    void theFreeMinuteIsTheRunsToo();
    void theFreeMinuteEndsByItself();
    void noLimitOfATrialEndsTheFreeMinute();
    void aSessionThatEndsByItselfIsTold();
    void withoutAFurtherStationItOnlyStaysOpen();
};

namespace {

double limitOf(const session::LiveSitting& live) {
    return live.level().parameters.as<simulation::SphereApexParameters>().trialLimit_s;
}

} // namespace

void TestLiveApex::noLimitOfATrialEndsTheFreeMinute() {
    psychophysics::StudyDesign of = design(3);
    of.trial.exploreLimit_s = 5.0;
    Site site(of);
    auto asked = site.request();
    asked.freeMinute_s = 60.0;
    auto started = session::LiveSitting::start(*site.fixture.database, site.actor, std::move(asked));
    QVERIFY(started);
    session::LiveSitting& live = **started;
    QVERIFY(limitOf(live) > 60.0);
    QTRY_COMPARE_WITH_TIMEOUT((live.poll(), live.view().state), View::trying, kPatience_ms);
    QCOMPARE(live.view().timeLeft_s, 0.0);
    live.endTrying();
    QTRY_COMPARE_WITH_TIMEOUT((live.poll(), live.view().state), View::exploring, kPatience_ms);
    QCOMPARE(limitOf(live), 5.0); // of the trials
    live.stop();
    QTRY_VERIFY_WITH_TIMEOUT((live.poll(), live.finished()), kPatience_ms);
}

/// Without a presentation no further session is begun, and the end is told from a stop.
void TestLiveApex::aSessionThatEndsByItselfIsTold() {
    Site site(design(2));
    const auto live = site.sit();
    live->training().post(core::CommandKind::end);
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->finished()), kPatience_ms);
    QCOMPARE(live->sessions(), 1);
    QVERIFY(live->result().has_value());
    QVERIFY(!live->result()->completed && live->result()->endedByItself);
}

/// A trial is left over because nobody provides the device again: nothing is wrong with it.
void TestLiveApex::withoutAFurtherStationItOnlyStaysOpen() {
    Site site(design(2));
    auto asked = site.request();
    asked.nextStation = {};
    auto started = session::LiveSitting::start(*site.fixture.database, site.actor, std::move(asked));
    QVERIFY(started);
    session::LiveSitting& live = **started;
    const auto places = tests::apexPlaces(live, site.run().seed, 0);
    QTRY_COMPARE_WITH_TIMEOUT((live.poll(), live.view().state), View::exploring, kPatience_ms);
    live.spoil();
    QVERIFY(mark(live, places));
    QVERIFY(mark(live, places));
    QTRY_VERIFY_WITH_TIMEOUT((live.poll(), live.finished()), kPatience_ms);
    QVERIFY(live.result().has_value());
    QVERIFY(!live.result()->completed && !live.result()->endedByItself);
}

/// No sphere of a trial comes before somebody says so.
void TestLiveApex::theFreeMinuteEndsByItself() {
    psychophysics::StudyDesign of = design(3);
    of.trial.practiceTrials = 1;
    Site site(of);
    auto asked = site.request();
    asked.freeMinute_s = 0.5;
    auto started = session::LiveSitting::start(*site.fixture.database, site.actor, std::move(asked));
    QVERIFY(started);
    session::LiveSitting& live = **started;
    QTRY_COMPARE_WITH_TIMEOUT((live.poll(), live.view().state), View::trying, kPatience_ms);
    int between = 0; // moments that are neither of the minute nor of its end
    const auto tried = [&] {
        live.poll();
        const auto view = live.view();
        between += view.tryLeft_s <= 0.0 && view.state != View::tried ? 1 : 0;
        return view.state == View::tried;
    };
    QTRY_VERIFY_WITH_TIMEOUT(tried(), kPatience_ms);
    QCOMPARE(between, 0);
    QCOMPARE(live.view().tryLeft_s, 0.0);
    QVERIFY(live.view().practice); // which comes next
    for (int i = 0; i < 20; ++i) {
        QTest::qWait(20);
        live.poll();
        QCOMPARE(live.view().state, View::tried);
    }
    QCOMPARE(live.sessions(), 1);
    live.endTrying();
    QTRY_COMPARE_WITH_TIMEOUT((live.poll(), live.view().state), View::exploring, kPatience_ms);
    QCOMPARE(live.sessions(), 2);
    QVERIFY(site.trials().empty());
    live.stop();
    QTRY_VERIFY_WITH_TIMEOUT((live.poll(), live.finished()), kPatience_ms);
}

/// The free minute has a session of its own, in which no trial is stored: it is known to be that
/// participant's all the same.
void TestLiveApex::theFreeMinuteIsTheRunsToo() {
    Site site(design(3));
    auto asked = site.request();
    asked.freeMinute_s = 60.0;
    auto live = session::LiveSitting::start(*site.fixture.database, site.actor, std::move(asked));
    QVERIFY(live);
    QTRY_VERIFY_WITH_TIMEOUT(
        ((*live)->poll(), (*live)->view().tryLeft_s > 0.0 && (*live)->view().tryLeft_s < 60.0), kPatience_ms);
    (*live)->stop();
    QTRY_VERIFY_WITH_TIMEOUT(((*live)->poll(), (*live)->finished()), kPatience_ms);
    QVERIFY(site.trials().empty());
    const auto reader = site.fixture.database->openReader();
    const auto runs = database::selectInteger(
        **reader, "SELECT count(*) FROM study_sitting s JOIN session x ON x.id = s.id WHERE s.run_id = ?",
        {site.run().id});
    QCOMPARE(runs->value_or(0), std::int64_t{1});
}

void TestLiveApex::marksBecomeTrialsAndTheAnalysisSaysTheSame() {
    Site site(design(3));
    const auto live = site.sit();
    const auto places = tests::apexPlaces(*live, site.run().seed, 0);
    QCOMPARE(places.size(), std::size_t(3));
    for (int i = 0; i < 3; ++i)
        QVERIFY2(mark(*live, places), "no trial came");
    const auto numbers = live->numbers();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->finished()), kPatience_ms);
    QVERIFY(live->result());
    QVERIFY(live->result()->completed);
    QCOMPARE(live->sessions(), 1);
    const auto trials = site.trials();
    QCOMPARE(trials.size(), std::size_t(3));
    for (const database::StudyTrial& trial : trials) {
        const auto error = session::apexMarkOf(trial.fidelityJson);
        QVERIFY(error);
        QVERIFY2(std::abs(error->errorX_m - kBeside_m) < kNear_m && std::abs(error->errorY_m) < kNear_m,
                 "the mark is not where it was set");
        QVERIFY(error->inContact);
        QCOMPARE(*trial.value, std::hypot(error->errorX_m, error->errorY_m));
    }
    auto connection = site.fixture.database->openReader();
    database::StudyReader reader(**connection, site.actor);
    const auto analysis = session::analyseStudy(reader, site.study, 5);
    QVERIFY(analysis);
    const auto& run = analysis->conditions.front().runs.front();
    QVERIFY(run.apex && numbers.apex);
    QCOMPARE(run.apex->trials, 3);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        QCOMPARE(run.apex->axes[axis].bias_mm, numbers.apex->axes[axis].bias_mm);
        QCOMPARE(run.apex->axes[axis].sd_mm, numbers.apex->axes[axis].sd_mm);
    }
    QCOMPARE(run.replayed.same, run.replayed.trials);
    auto stored = session::SessionView::open(**connection, site.actor, trials.front().session);
    QVERIFY(stored);
    const auto replayed = session::replaySession(**stored); // to the same bits
    QVERIFY2(replayed, replayed ? "" : replayed.error().message.c_str());
    QVERIFY(replayed->identical);
}

void TestLiveApex::aSpoiledTrialComesAgainInAFurtherSession() {
    Site site(design(2));
    const auto live = site.sit();
    const auto first = tests::apexPlaces(*live, site.run().seed, 0);
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().state == View::exploring), kPatience_ms);
    live->spoil();
    QVERIFY(live->numbers().spoiling);
    QVERIFY(mark(*live, first));
    QVERIFY(!live->numbers().spoiling);
    QCOMPARE(live->numbers().spoiled, 1);
    QVERIFY(mark(*live, first));
    QTRY_COMPARE_WITH_TIMEOUT((live->poll(), live->sessions()), 2, kPatience_ms);
    const auto further = tests::apexPlaces(*live, site.run().seed, 2);
    QCOMPARE(further.size(), std::size_t(1));
    QVERIFY(mark(*live, further));
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->finished()), kPatience_ms);
    QVERIFY(live->result()->completed);
    const auto trials = site.trials();
    QCOMPARE(trials.size(), std::size_t(3));
    QCOMPARE(trials[0].spoiled, std::string("experimenter"));
    QCOMPARE(trials[0].outcome, -1);
    QVERIFY(trials[2].session != trials[1].session);
    QCOMPARE(trials[1].session, trials[0].session);
}

void TestLiveApex::stopsAndGoesOnAtTheTrial() {
    Site site(design(2));
    {
        const auto live = site.sit();
        QVERIFY(mark(*live, tests::apexPlaces(*live, site.run().seed, 0)));
        QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().state == View::exploring), kPatience_ms);
        live->stop();
        QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->finished()), kPatience_ms);
        QVERIFY(live->result() && !live->result()->completed && !live->result()->endedByItself);
    }
    auto trials = site.trials();
    QCOMPARE(trials.size(), std::size_t(2));
    QCOMPARE(trials[1].spoiled, std::string("stopped"));
    const auto live = site.sit();
    QCOMPARE(live->numbers().scored, 1);
    QCOMPARE(live->numbers().spoiled, 0); // the interrupted one is no repeat
    QVERIFY(live->numbers().apex->trials == 1);
    QVERIFY(mark(*live, tests::apexPlaces(*live, site.run().seed, 2)));
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->finished()), kPatience_ms);
    QVERIFY(live->result()->completed);
    trials = site.trials();
    QCOMPARE(trials.size(), std::size_t(3));
    QCOMPARE(trials[2].ordinal, 2);
}

void TestLiveApex::forceIsStoppedAndRearmed() {
    Site site(design(1));
    const auto live = site.sit();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().state == View::exploring), kPatience_ms);
    live->stopForce();
    QCOMPARE(live->view().state, View::stopped);
    // Not at the window's next look, which may be long in coming.
    QTRY_VERIFY_WITH_TIMEOUT((live->training().beat(), live->training().display().latest().paused),
                             kPatience_ms);
    live->resume(); // that takes more
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->training().display().latest().paused), kPatience_ms);
    QCOMPARE(live->view().state, View::stopped);
    QVERIFY(!live->answer(0));
    live->rearm();
    QTRY_COMPARE_WITH_TIMEOUT((live->poll(), live->view().state), View::exploring, kPatience_ms);
    live->pause(); // by the person: going on takes no arming
    QCOMPARE(live->view().state, View::paused);
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->training().display().latest().paused), kPatience_ms);
    QVERIFY(!live->answer(0));
    live->resume();
    QTRY_COMPARE_WITH_TIMEOUT((live->poll(), live->view().state), View::exploring, kPatience_ms);
    QVERIFY(mark(*live, tests::apexPlaces(*live, site.run().seed, 0)));
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->finished()), kPatience_ms);
    QVERIFY(live->result()->completed);
}

void TestLiveApex::aBreakHoldsTheExercise() {
    psychophysics::StudyDesign of = design(2);
    of.trial.breakEvery = 1;
    of.trial.breakAtLeast_s = 0.2;
    of.trial.feedback = true;
    Site site(of);
    const auto live = site.sit();
    const auto places = tests::apexPlaces(*live, site.run().seed, 0);
    QVERIFY(mark(*live, places));
    QCOMPARE(live->view().state, View::feedback);
    QVERIFY(std::abs(*live->view().beside_m - kBeside_m) < kNear_m);
    QTRY_COMPARE_WITH_TIMEOUT((live->poll(), live->view().state), View::breakDue, kPatience_ms);
    QTest::qWait(600);
    live->poll();
    QVERIFY(live->training().display().latest().phase !=
            core::TrialPhase::running); // longer than the time between trials
    live->breakTaken();
    QVERIFY(mark(*live, places));
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->finished()), kPatience_ms);
    QVERIFY(live->result()->completed);
}

void TestLiveApex::aDeviceThatIsTooSlowIsRefused() {
    Site site(design(1));
    const auto kind = session::exerciseKind("sphere_apex");
    auto request = site.request();
    catalogue::ExerciseLevel level;
    {
        const auto live = site.sit();
        level = live->level();
        live->stop();
        QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->finished()), kPatience_ms);
    }
    request.station = std::move(*session::scriptedStation(**kind, level, "expert", 1)); // renders force
    request.measuredDelay_s = 0.020;                                                    // 98 N/m
    const auto live = session::LiveSitting::start(*site.fixture.database, site.actor, std::move(request));
    auto justEnough = site.request();
    justEnough.station = std::move(*session::scriptedStation(**kind, level, "expert", 1));
    justEnough.measuredDelay_s = 0.0035; // 2 N·s/m / (0.5 ms + 3.5 ms): 500 N/m, as the sphere has
    const auto other = session::LiveSitting::start(*site.fixture.database, site.actor, std::move(justEnough));
    QVERIFY2(other, other ? "" : other.error().message.c_str());
    (*other)->stop();
    QTRY_VERIFY_WITH_TIMEOUT(((*other)->poll(), (*other)->finished()), kPatience_ms);
    QVERIFY(!live);
    QVERIFY2(live.error().message.find("500 N/m") != std::string::npos &&
                 live.error().message.find("98 N/m") != std::string::npos,
             live.error().message.c_str());
    const auto& typed = live.error().tooStiff; // a window has its own words for it
    QVERIFY(typed && typed->sphere_N_per_m == 500.0 && std::lround(typed->device_N_per_m) == 98);
}

/// A window that sleeps for too long is told that ticks are missing, and of every event.
void TestLiveApex::lostTicksAreSaid() {
    const auto tap = std::make_unique<session::ApexTap>();
    core::HapticFrame frame{};
    while (tap->tryPush(frame)) {
    }
    frame.header.events = core::event_bits::kMarked;
    QVERIFY(!tap->tryPush(frame));
    session::ApexTick tick;
    while (tap->ring().tryPop(tick))
        QVERIFY(!tick.lost && tick.sample.events == 0);
    frame.header.events = 0;
    QVERIFY(tap->tryPush(frame) && tap->tryPush(frame));
    QVERIFY(tap->ring().tryPop(tick));
    QVERIFY(tick.lost && tick.sample.events == core::event_bits::kMarked);
    QVERIFY(tap->ring().tryPop(tick));
    QVERIFY(!tick.lost && tick.sample.events == 0);
}

QTEST_GUILESS_MAIN(TestLiveApex)
#include "test_live_apex.moc"
