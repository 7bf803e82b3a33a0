// SPDX-License-Identifier: GPL-3.0-or-later
// A sitting in real time without a window: pausing before the loop ticks, events that a sleeping window
// misses, the delay of a device.
#include "catalogue/study_json.h"
#include "database/accounts/account_service.h"
#include "database/repositories/study_reader.h"
#include "database/repositories/study_repository.h"
#include "session/study/live_study.h"
#include "session/study/presentation_order.h"
#include "session/study/sample_tap.h"
#include "session/study/study_analysis.h"
#include "session/study/study_setup.h"
#include "session/study/study_store.h"
#include "session/study/trial_fidelity.h"
#include "session/study_export.h"
#include "support/patience.h"
#include "support/session_fixture.h"
#include "support/study_designs.h"

#include <QDirIterator>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

using chiron::tests::kPatience_ms;

using namespace chiron;
using View = session::LiveStudyView::State;

namespace {

constexpr const char* kPassword = "a long password for tests";

/// A frozen study of one condition with one participant who has consented.
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
    explicit Site(bool blind = false, const std::function<void(psychophysics::StudyDesign&)>& change = {}) {
        design = testing::rank3Study();
        if (blind) {
            design.conditions.push_back(design.conditions.front());
            design.conditions.back().id = "stiffer";
            design.conditions.back().stimulus.reference = 437.5;
            design.blindExperimenter = true;
        }
        design.trial.mustTouchAll = false;
        if (change)
            change(design);
        database::AccountService accounts(*fixture.database);
        if (!accounts.createFirstAdministrator("ada", kPassword, "Ada"))
            qFatal("no administrator");
        const auto ada = accounts.login("ada", kPassword);
        if (!accounts.createPerson(
                *ada, {"rhea", "Rhea", database::RoleSet{database::Role::researcher}, kPassword, false}))
            qFatal("no researcher");
        actor = *accounts.login("rhea", kPassword);
        study = *write([&](database::StudyRepository& studies) {
            return studies.createStudy(design.id, "A study", catalogue::studyJson(design).toStdString());
        });
        write([&](database::StudyRepository& studies) { return studies.freezeStudy(study); });
        const auto who = *write([&](database::StudyRepository& studies) {
            return studies.enrolParticipant(study, "somebody", 0, {});
        });
        write([&](database::StudyRepository& studies) {
            return studies.recordConsent(
                who.id, catalogue::studySha256(QByteArray::fromStdString(design.consent.at("en"))));
        });
        code = who.code;
    }
    session::LiveStudyRequest request() const {
        session::LiveStudyRequest request;
        request.study = study;
        request.participantCode = code;
        request.ringFolder = recording::defaultRingFolder();
        auto station = session::keyboardMouseStation();
        if (!station)
            qFatal("%s", station.error().message.c_str());
        request.station = std::move(*station);
        return request;
    }
    /// On a device that renders force, with this delay.
    session::SittingError refusal(double delay_s) {
        auto asked = request();
        const auto kind = session::exerciseKind("comparison");
        const auto level = session::studyLevel(design, design.conditions.front());
        asked.station = std::move(*session::scriptedStation(**kind, *level, "participant", 1));
        asked.measuredDelay_s = delay_s;
        auto live = session::LiveStudy::start(*fixture.database, actor, std::move(asked));
        if (live)
            qFatal("it was not refused");
        return live.error();
    }
    std::unique_ptr<session::LiveStudy> sit(double freeMinute_s = 0.0) {
        auto asked = request();
        asked.freeMinute_s = freeMinute_s;
        asked.language = "de";
        auto live = session::LiveStudy::start(*fixture.database, actor, std::move(asked));
        if (!live)
            qFatal("%s", live.error().message.c_str());
        return std::move(*live);
    }

    tests::SessionFixture fixture;
    database::Actor actor = database::Actor::simulated();
    psychophysics::StudyDesign design;
    database::StudyNumber study = 0;
    std::string code;
};

} // namespace

class TestLiveStudy : public QObject {
    Q_OBJECT
private slots:
    void pausedAndResumedBeforeTheFirstTick();
    void pausesAndGoesOn();
    void noClockRunsWhilePaused();
    void theTrialAtHandIsTold();
    void practiceTellsOfEveryObjectThatItWasRight();
    void anUnknownConditionIsRefused();
    void timeIsNeverUpWithoutAnAnswer();
    void whatIsShownIsNotInTheGroup();
    void stopsWhilePaused();
    void stopsBeforeItBegan();
    void aBlindExperimenterIsToldNoCondition();
    void noEventIsMissed();
    void limitsOfAnUnmeasuredDeviceAreCautious();
    void whatADeviceCannotRenderIsTyped();
    void anotherVersionNeverGoesOn();
    void theFreeMinuteIsOfNoTrial();
    void theFreeMinuteEndsByItself();
    void noLimitOfATrialEndsTheFreeMinute();
    void stoppedInTheFreeMinute();
    void betweenTrialsOfPracticeIsPractice();
    void aSessionThatEndsByItselfIsTold();
    void practiceIsTakenBackAndRunAgain();
    void aHandThatMovesTooFastIsTold();
    void whatASittingNotesIsExported();
    void forceIsStoppedAtOnceAndRearmed();
    void aScoredTrialIsToldWhereTheDesignSaysSo();
};

/// Instructions are read before the session is up, for as long as it takes: however often a pause is asked
/// for, going on is heard.
void TestLiveStudy::pausedAndResumedBeforeTheFirstTick() {
    Site site;
    const auto live = site.sit();
    for (int asked = 0; asked < 200; ++asked) // more often than the loop's ring holds commands
        live->pause();
    live->resume();
    QTRY_VERIFY2_WITH_TIMEOUT((live->poll(), live->view().canAnswer), "paused for ever", kPatience_ms);
}

void TestLiveStudy::pausesAndGoesOn() {
    Site site;
    const auto live = site.sit();
    live->pause();
    QCOMPARE(live->view().state, View::paused); // asked for is enough: the next key press means "go on"
    QTest::qWait(300);
    live->poll();
    QCOMPARE(live->view().state, View::paused);
    QVERIFY(!live->view().canAnswer);
    live->resume();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
    QVERIFY(live->answer(0).has_value());
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->numbers().scored + live->numbers().spoiled == 1),
                             kPatience_ms);
}

/// What is stored of a trial holds its pause beside its time, and not in it; of a device that renders no
/// force it says so.
void TestLiveStudy::noClockRunsWhilePaused() {
    Site site;
    const auto live = site.sit();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
    live->pause();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->training().display().latest().paused), kPatience_ms);
    const double left_s = live->view().timeLeft_s;
    QTest::qWait(1500);
    live->poll();
    QVERIFY2(live->view().timeLeft_s > left_s - 0.1 || live->view().timeLeft_s == 0.0,
             qPrintable(QString::number(live->view().timeLeft_s)));
    live->resume();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
    QVERIFY(live->answer(0).has_value());
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->numbers().scored + live->numbers().spoiled == 1),
                             kPatience_ms);
    auto connection = site.fixture.database->openReader();
    database::StudyReader reader(**connection, site.actor);
    const auto runs = reader.runs(reader.participantByCode(site.study, site.code)->id);
    const auto trials = reader.studyTrials(runs->front().id);
    QCOMPARE(trials->size(), std::size_t{1});
    const database::StudyTrial& trial = trials->front();
    const double paused_s = session::pausedOf(trial.fidelityJson),
                 whole_s = 1e-3 * static_cast<double>(trial.lastTick - trial.firstTick);
    QVERIFY2(paused_s > 1.0, trial.fidelityJson.c_str());
    QVERIFY2(std::abs(trial.exploration_s + paused_s - whole_s) < 0.0025, trial.fidelityJson.c_str());
    QVERIFY(trial.answer_s <= trial.exploration_s);
    QCOMPARE(trial.answer, 0);                                    // as it was given
    QVERIFY(trial.felt && !*trial.felt && !trial.device.empty()); // keyboard and mouse
    const QJsonObject fidelity =
        QJsonDocument::fromJson(QByteArray::fromStdString(trial.fidelityJson)).object();
    QVERIFY(fidelity["shown"].toBool() && fidelity["stiffness_error"].isNull() &&
            fidelity["saturated"].isNull() && fidelity["peak_force_N"].isNull());
}

/// A run with mouse and keyboard says in every table that it was shown, and belongs to the group only where
/// that is asked for.
void TestLiveStudy::whatIsShownIsNotInTheGroup() {
    Site site;
    {
        const auto live = site.sit();
        QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
        QVERIFY(live->answer(0).has_value());
        QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->numbers().scored + live->numbers().spoiled == 1),
                                 kPatience_ms);
        live->stop();
        QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->finished()), kPatience_ms);
    }
    auto connection = site.fixture.database->openReader();
    database::StudyReader reader(**connection, site.actor);
    for (const bool withShown : {false, true}) {
        const auto analysis = session::analyseStudy(reader, site.study, 1, {.withShown = withShown});
        QVERIFY(analysis);
        const session::AnalysedCondition& condition = analysis->conditions.front();
        const session::AnalysedRun& run = condition.runs.front();
        QVERIFY(run.felt && !*run.felt && run.pooled == withShown);
        QVERIFY(psychophysics::hasWarning(run.estimate.warnings, psychophysics::WarningKind::shownRun));
        QVERIFY(psychophysics::hasWarning(condition.group.warnings,
                                          withShown ? psychophysics::WarningKind::shownInGroup
                                                    : psychophysics::WarningKind::shownLeftOut));
        QVERIFY(analysis->quality.front().felt && !*analysis->quality.front().felt);
    }
    QTemporaryDir folder;
    QVERIFY(session::exportStudyCsv(reader, site.study, folder.filePath("csv").toStdString()));
    QVERIFY(session::exportStudyBids(reader, **connection, site.actor, site.study,
                                     folder.filePath("bids").toStdString()));
    QStringList tables{folder.filePath("csv/trials.csv"), folder.filePath("csv/runs.csv"),
                       folder.filePath("csv/quality.csv")};
    QDirIterator beh(folder.filePath("bids"), {"*_beh.tsv"}, QDir::Files, QDirIterator::Subdirectories);
    while (beh.hasNext())
        tables << beh.next();
    QCOMPARE(tables.size(), qsizetype{4});
    for (const QString& path : tables) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray separator = path.endsWith(".tsv") ? "\t" : ",";
        const QList<QByteArray> lines = file.readAll().trimmed().split('\n');
        const auto names = lines[0].split(separator[0]), cells = lines[1].split(separator[0]);
        QCOMPARE(cells.value(names.indexOf("force_class")), QByteArray("shown"));
        QVERIFY2(names.contains("device") && cells.value(names.indexOf("device")) != "n/a" &&
                     !cells.value(names.indexOf("device")).isEmpty(),
                 lines[1].constData());
    }
}

void TestLiveStudy::anUnknownConditionIsRefused() {
    Site site;
    auto asked = site.request();
    asked.condition = "nowhere";
    const auto live = session::LiveStudy::start(*site.fixture.database, site.actor, std::move(asked));
    QVERIFY(!live);
    QCOMPARE(live.error().code, core::ErrorCode::notFound);
    QVERIFY2(live.error().message.find("nowhere") != std::string::npos, live.error().message.c_str());
}

/// Practice tells what was right, a scored trial where the design says so; then a break is due, and for how
/// long.
void TestLiveStudy::theTrialAtHandIsTold() {
    Site site(false, [](psychophysics::StudyDesign& design) {
        design.trial.exploreLimit_s = 25.0;
        design.trial.betweenTrials_s = 0.0;
        design.trial.practiceTrials = 1;
        design.trial.breakEvery = 1;
        design.trial.breakAtLeast_s = 40.0;
        design.fidelity.lateTicks = 1.0; // on a busy machine, too
    });
    const auto live = site.sit();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
    const session::LiveStudyView first = live->view();
    QVERIFY(first.state == View::exploring && first.practice && first.trial == 0 && first.places == 3 &&
            first.place == -1 && first.touched == 0);
    QCOMPARE(first.ofAtMost, session::trialsAtMost(live->condition()));
    QVERIFY(first.timeLeft_s > 0.0 && first.timeLeft_s <= 25.0 && first.breakLeft_s == 0.0 && !first.right);
    QVERIFY(live->numbers().practice == 0 && live->numbers().repeats == 0 &&
            live->numbers().lastSpoiled.empty());
    QVERIFY(live->answer(2).has_value());
    QVERIFY(!live->answer(2)); // once
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().mayTakeBack),
                             kPatience_ms); // told first, and stored once nobody takes it back
    const session::LiveStudyView told = live->view();
    QCOMPARE(live->numbers().practice, 0);
    live->goOn();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->numbers().practice == 1), kPatience_ms);
    const auto stored = [&](std::size_t trial) {
        auto connection = site.fixture.database->openReader();
        database::StudyReader reader(**connection, site.actor);
        const auto runs = reader.runs(reader.participantByCode(site.study, site.code)->id);
        return reader.studyTrials(runs->front().id)->at(trial);
    };
    const database::StudyTrial practised = stored(0);
    QVERIFY(practised.practice && practised.answer == 2 && practised.ordinal == 0);
    QVERIFY(told.state == View::feedback && told.practice && told.trial == 0 &&
            told.ofAtMost == first.ofAtMost);
    QCOMPARE(told.right, std::optional(psychophysics::correctAnswer(psychophysics::Task::rank3,
                                                                    practised.arrangement) == 2));
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
    QVERIFY(!live->view().practice && !live->view().right);
    QVERIFY(live->answer(1).has_value());
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->numbers().scored == 1), kPatience_ms);
    const session::LiveStudyView rest = live->view();
    QVERIFY(!rest.right); // scored ones are not told
    QVERIFY(!stored(1).practice && stored(1).answer == 1 && stored(1).ordinal == 1);
    QVERIFY(rest.state == View::breakDue && rest.trial == 1 && !rest.canAnswer && rest.timeLeft_s == 0.0);
    QVERIFY(rest.breakLeft_s > 0.0 && rest.breakLeft_s <= 40.0);
    QCOMPARE(live->numbers().practice, 1);
}

/// Whichever object is asked for: each of the three is told to be right where it is, the first one, too.
void TestLiveStudy::practiceTellsOfEveryObjectThatItWasRight() {
    constexpr int kTrials = 60; // three of so many guesses among three are right, but for a chance of 1e-8
    Site site(false, [](psychophysics::StudyDesign& design) {
        design.trial.betweenTrials_s = 0.0;
        design.trial.practiceTrials = kTrials;
        design.fidelity.lateTicks = 1.0;
    });
    const auto live = site.sit();
    std::array<int, 3> right{};
    for (int trial = 0; trial < kTrials && *std::min_element(right.begin(), right.end()) == 0; ++trial) {
        const int next = static_cast<int>(std::min_element(right.begin(), right.end()) - right.begin());
        QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
        QVERIFY(live->answer(next).has_value());
        QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().mayTakeBack), kPatience_ms);
        QVERIFY(live->view().right.has_value());
        right[static_cast<std::size_t>(next)] += *live->view().right ? 1 : 0;
        live->goOn();
    }
    QVERIFY(*std::min_element(right.begin(), right.end()) > 0);
}

/// Objects that were not all touched when they go cannot be answered about: the trial ends at once and comes
/// again, and nobody is asked for an answer.
void TestLiveStudy::timeIsNeverUpWithoutAnAnswer() {
    Site site(false, [](psychophysics::StudyDesign& design) {
        design.trial.mustTouchAll = true;
        design.trial.exploreLimit_s = 5.0; // the shortest that a design may have
        design.trial.answerLimit_s = 60.0;
    });
    const auto live = site.sit();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().state == View::exploring), kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(
        (live->poll(), live->view().state == View::answering || live->numbers().spoiled == 1), kPatience_ms);
    QCOMPARE(live->numbers().spoiled, 1);
    QCOMPARE(live->numbers().lastSpoiled, std::string("untouched"));
    QCOMPARE(live->view().unanswered, std::string("untouched"));
    QVERIFY(live->view().missed == session::LiveStudyView::Missed::never); // nobody moved the tool
}

void TestLiveStudy::stopsWhilePaused() {
    Site site;
    const auto live = site.sit();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
    live->pause();
    live->stop();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->finished()), kPatience_ms);
    QVERIFY(live->result().has_value());
    QVERIFY(!live->result()->completed && !live->result()->endedByItself);
    // What was asked of the loop is recorded, from the start on.
    auto connection = site.fixture.database->openReader();
    const auto events = database::SessionReader(**connection, site.actor).events(live->result()->session);
    QVERIFY(events.has_value());
    for (const char* kind : {"start", "pause"})
        QCOMPARE(std::count_if(events->begin(), events->end(),
                               [&](const auto& event) { return event.kind == kind; }),
                 1);
}

/// Stopped while the instructions are read: a pause that is asked for later does not hold it up.
void TestLiveStudy::stopsBeforeItBegan() {
    Site site;
    const auto live = site.sit();
    live->pause();
    live->stop();
    live->pause();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->finished()), kPatience_ms);
    QVERIFY(live->result().has_value());
    QVERIFY(!live->result()->completed);
}

/// Beside the trials: the sealed code, no estimate, and nothing of forces, which are those of the condition.
/// It is rendered all the same.
void TestLiveStudy::aBlindExperimenterIsToldNoCondition() {
    Site site(true);
    const auto live = site.sit();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
    QVERIFY(live->answer(0).has_value());
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->numbers().scored + live->numbers().spoiled == 1),
                             kPatience_ms);
    const session::LiveStudyNumbers numbers = live->numbers();
    const auto looked = site.fixture.database->write([&](database::WriteContext& w) {
        return database::StudyReader(w.connection(), site.actor).sealedConditions(site.study);
    });
    QVERIFY(looked);
    const auto mine = std::find_if(looked->begin(), looked->end(),
                                   [&](const auto& each) { return each.sealedCode == numbers.sealedCode; });
    QVERIFY(mine != looked->end());
    QCOMPARE(live->condition().id, mine->condition);
    QVERIFY(numbers.blind);
    QCOMPARE(numbers.condition, numbers.sealedCode);
    QVERIFY(numbers.estimates.empty());
    const session::TrialFidelity& fidelity = numbers.lastFidelity;
    QVERIFY(std::isnan(fidelity.peakForce_N) && std::isnan(fidelity.stiffnessError) &&
            std::isnan(fidelity.forceErrorRms_N) && std::isnan(fidelity.saturated));
    QVERIFY(fidelity.places.empty() && fidelity.duration_s > 0.0);
    Site open;
    QVERIFY(!open.sit()->numbers().blind);
    QCOMPARE(open.sit()->numbers().condition, std::string("main"));
}

/// A window that sleeps for longer than the tap holds is told of a trial's end all the same.
void TestLiveStudy::noEventIsMissed() {
    session::SampleTap tap;
    core::HapticFrame frame{};
    for (std::size_t i = 0; tap.tryPush(frame); ++i)
        QVERIFY(i <= session::SampleTap::kSamples);
    frame.header.events = core::event_bits::kCompleted;
    QVERIFY(!tap.tryPush(frame));
    session::FidelitySample sample;
    while (tap.ring().tryPop(sample))
        QCOMPARE(sample.events, 0u);
    frame.header.events = core::event_bits::kContactBegan;
    QVERIFY(tap.tryPush(frame) && tap.tryPush(frame));
    QVERIFY(tap.ring().tryPop(sample));
    QCOMPARE(sample.events, std::uint32_t{core::event_bits::kCompleted | core::event_bits::kContactBegan});
    QVERIFY(tap.ring().tryPop(sample));
    QCOMPARE(sample.events, std::uint32_t{core::event_bits::kContactBegan}); // once
}

void TestLiveStudy::limitsOfAnUnmeasuredDeviceAreCautious() {
    devices::DeviceDescriptor device;
    device.rendersForce = true;
    device.period_us = 1000;
    const session::RenderingLimits unmeasured = session::limitsAt(device, std::nullopt);
    QVERIFY(!unmeasured.measured);
    QCOMPARE(unmeasured.delay_s, 0.002); // a period old when it is read, a period until it is sent
    QCOMPARE(unmeasured.largestStiffness_N_per_m, 2.0 / 0.0025); // devices.md §6: 800 N/m at 2 ms
    const session::RenderingLimits measured = session::limitsAt(device, 0.0005);
    QVERIFY(measured.measured);
    QCOMPARE(measured.delay_s, 0.0005);
    QCOMPARE(measured.largestStiffness_N_per_m, 2.0 / 0.001);
    QVERIFY(!session::limitsAt(device, std::nan("")).measured);
    QCOMPARE(session::limitsAt(device, 0.0).delay_s, 0.002); // nothing is that quick
    device.inProcess = true;
    QCOMPARE(session::limitsAt(device, std::nullopt).delay_s, 0.0);
}

/// A window has its own words for both; nothing is stored of a sitting that does not begin.
void TestLiveStudy::whatADeviceCannotRenderIsTyped() {
    for (const bool blind : {false, true}) {
        Site site(blind);
        const session::SittingError none = site.refusal(0.1); // 20 N/m: not even the reference
        QVERIFY2(none.device == session::DeviceRefusal::rendersNone, none.message.c_str());
        QVERIFY(!none.tooStiff);
        site.sit(); // without force there is no limit
        const session::SittingError less = site.refusal(0.1);
        QVERIFY2(less.device == session::DeviceRefusal::rendersLess, less.message.c_str());
    }
    Site site;
    auto asked = site.request();
    asked.participantCode = "ZZZ-ZZZ";
    const auto unknown = session::LiveStudy::start(*site.fixture.database, site.actor, std::move(asked));
    QVERIFY(!unknown && !unknown.error().device && !unknown.error().tooStiff);
}

void TestLiveStudy::anotherVersionNeverGoesOn() {
    Site site;
    const auto opened = session::openStudy(*site.fixture.database, site.actor, site.study, site.code);
    QVERIFY(opened && session::beginRun(*site.fixture.database, site.actor, *opened, opened->order.front(), 1,
                                        "rank3_quest_plus@0"));
    const auto live = session::LiveStudy::start(*site.fixture.database, site.actor, site.request());
    QVERIFY(!live && live.error().otherVersion && !live.error().device);
    QCOMPARE(live.error().code, core::ErrorCode::wrongUse);
}

namespace {

std::vector<database::StudyTrial> storedTrials(Site& site) {
    auto connection = site.fixture.database->openReader();
    database::StudyReader reader(**connection, site.actor);
    const auto runs = reader.runs(reader.participantByCode(site.study, site.code)->id);
    return runs->empty() ? std::vector<database::StudyTrial>() : *reader.studyTrials(runs->front().id);
}

} // namespace

void TestLiveStudy::theFreeMinuteIsOfNoTrial() {
    Site site;
    const auto live = site.sit(60.0);
    QTRY_COMPARE_WITH_TIMEOUT((live->poll(), live->view().state), View::trying, kPatience_ms);
    QVERIFY(!live->view().canAnswer && !live->answer(0));
    live->pause();
    QTRY_COMPARE_WITH_TIMEOUT((live->poll(), live->view().state), View::paused, kPatience_ms);
    live->resume();
    QTRY_COMPARE_WITH_TIMEOUT((live->poll(), live->view().state), View::trying, kPatience_ms);
    live->endTrying();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
    QCOMPARE(live->view().tryLeft_s, 0.0);
    QVERIFY(live->answer(0));
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->numbers().scored + live->numbers().spoiled == 1),
                             kPatience_ms);
    const auto trials = storedTrials(site);
    QCOMPARE(trials.size(), std::size_t{1});
    QCOMPARE(trials.front().ordinal, 0);
    QVERIFY(trials.front().firstTick > 0); // after what was tried, in the same recording
    live->stop();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->finished()), kPatience_ms);
    const auto again = site.sit(60.0); // gone on with: no further minute
    QCOMPARE(again->view().tryLeft_s, 0.0);
}

void TestLiveStudy::theFreeMinuteEndsByItself() {
    Site site;
    const auto live = site.sit(1.0);
    QTRY_COMPARE_WITH_TIMEOUT((live->poll(), live->view().state), View::trying, kPatience_ms);
    int between = 0; // moments that are neither of the minute nor of its end
    const auto tried = [&] {
        live->poll();
        const auto view = live->view();
        between += view.tryLeft_s <= 0.0 && view.state != View::tried ? 1 : 0;
        return view.state == View::tried;
    };
    QTRY_VERIFY_WITH_TIMEOUT(tried(), kPatience_ms);
    QCOMPARE(between, 0);
    QCOMPARE(live->view().tryLeft_s, 0.0);
    for (int i = 0; i < 20; ++i) { // and no trial begins before somebody says so
        QTest::qWait(20);
        live->poll();
        QCOMPARE(live->view().state, View::tried);
    }
    live->endTrying();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
    QVERIFY(storedTrials(site).empty());
}

/// Objects stay for all of it, however short a trial is: they were presented once.
void TestLiveStudy::noLimitOfATrialEndsTheFreeMinute() {
    Site site(false, [](psychophysics::StudyDesign& design) { design.trial.exploreLimit_s = 0.4; });
    const auto live = site.sit(1.5);
    QTRY_COMPARE_WITH_TIMEOUT((live->poll(), live->view().state), View::trying, kPatience_ms);
    QTRY_COMPARE_WITH_TIMEOUT((live->poll(), live->view().state), View::tried, kPatience_ms);
    live->stop();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->finished()), kPatience_ms);
    QVERIFY(live->result().has_value());
    auto connection = site.fixture.database->openReader();
    const auto events = database::SessionReader(**connection, site.actor).events(live->result()->session);
    QVERIFY(events.has_value());
    QCOMPARE(std::count_if(events->begin(), events->end(),
                           [](const auto& event) { return event.kind == "presented"; }),
             1);
}

/// Whoever waits for the next objects of practice is not told that they count.
void TestLiveStudy::betweenTrialsOfPracticeIsPractice() {
    Site site(false, [](psychophysics::StudyDesign& design) {
        design.trial.practiceTrials = 2;
        design.trial.betweenTrials_s = 0.5;
    });
    const auto live = site.sit();
    bool always = true;
    const auto canAnswer = [&] {
        live->poll();
        always = always && live->view().practice;
        return live->view().canAnswer;
    };
    for (int trial = 0; trial < 2; ++trial) {
        QTRY_VERIFY_WITH_TIMEOUT(canAnswer(), kPatience_ms);
        QVERIFY(always);
        QVERIFY(live->answer(0).has_value());
        QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().mayTakeBack), kPatience_ms);
        live->goOn();
    }
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
    QVERIFY(!live->view().practice);
}

/// Nobody stopped it, and trials are left: that is another thing than a stop.
void TestLiveStudy::aSessionThatEndsByItselfIsTold() {
    Site site;
    const auto live = site.sit();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
    live->training().post(core::CommandKind::end);
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->finished()), kPatience_ms);
    QVERIFY(live->result().has_value());
    QVERIFY(!live->result()->completed && live->result()->endedByItself);
}

void TestLiveStudy::stoppedInTheFreeMinute() {
    Site site;
    {
        const auto live = site.sit(60.0);
        QTRY_COMPARE_WITH_TIMEOUT((live->poll(), live->view().state), View::trying, kPatience_ms);
        live->stop();
        QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->finished()), kPatience_ms);
        QVERIFY(live->result() && !live->result()->completed);
    }
    QVERIFY(storedTrials(site).empty());
    const auto again = site.sit(60.0); // nothing was done yet: the minute is offered again
    QVERIFY(again->view().tryLeft_s > 0.0);
}

/// What somebody can do otherwise is said to them, instead of objects that come again without a word; until
/// the next ones are there.
void TestLiveStudy::aHandThatMovesTooFastIsTold() {
    Site site(false, [](psychophysics::StudyDesign& design) {
        design.trial.practiceTrials = 1;
        design.fidelity.meanSpeed_m_per_s = 0.001;
        design.fidelity.lateTicks = 1.0; // on a busy machine, too
    });
    const auto live = site.sit();
    const auto move = [&] { // to and fro, above the objects
        for (int i = 0; i < 20; ++i) {
            live->training().pointer()->move(i % 2 == 0 ? 0.005 : -0.005, 0.0, 0.0);
            QTest::qWait(20);
        }
    };
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
    QVERIFY(live->view().hand.empty());
    move();
    QVERIFY(live->answer(0).has_value());
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().state == View::feedback), kPatience_ms);
    QVERIFY(!live->view().right); // neither right nor wrong
    QCOMPARE(live->view().hand, std::string("speed"));
    live->goOn();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
    QVERIFY(!live->view().practice && live->view().hand.empty());
    move();
    QVERIFY(live->answer(0).has_value());
    QTRY_COMPARE_WITH_TIMEOUT((live->poll(), live->view().hand), std::string("speed"),
                              kPatience_ms); // this one comes again
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
    QVERIFY(live->view().hand.empty());
}

/// Kept as taken back, run again by the log, and asked for as often as it takes.
void TestLiveStudy::practiceIsTakenBackAndRunAgain() {
    Site site(false, [](psychophysics::StudyDesign& design) {
        design.trial.practiceTrials = 1;
        design.fidelity.repeatsAtMost = 2;
    });
    const auto live = site.sit();
    const auto answered = [&] {
        return QTest::qWaitFor([&] { return live->poll(), live->view().canAnswer; }, kPatience_ms) &&
               live->answer(0) &&
               QTest::qWaitFor([&] { return live->poll(), live->view().mayTakeBack; }, kPatience_ms);
    };
    for (int i = 0; i < 3;
         ++i) { // more often than a spoiled trial may come again: the experimenter is not called for it
        QVERIFY(answered());
        QCOMPARE(live->view().state, View::feedback);
        live->takeBack();
        live->poll();
        QVERIFY(live->view().state != View::needsExperimenter);
    }
    QVERIFY(answered());
    QVERIFY(live->view().practice);
    QCOMPARE(storedTrials(site).size(), std::size_t{3}); // the last one can still be taken back
    live->stop();                                        // it is kept with the stop
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->finished()), kPatience_ms);
    const auto trials = storedTrials(site);
    QCOMPARE(trials.size(), std::size_t{4});
    QVERIFY(trials[0].practice && trials[0].answer == -1 && trials[0].spoiled == "taken_back");
    QCOMPARE(trials[3].answer, 0);
    auto connection = site.fixture.database->openReader();
    database::StudyReader reader(**connection, site.actor);
    const auto runs = reader.runs(reader.participantByCode(site.study, site.code)->id);
    const auto replayed = session::rerunChoices(site.design, runs->front(), trials);
    QVERIFY(replayed);
    QCOMPARE(replayed->same, 4);
    const auto again = site.sit();
    QTRY_VERIFY_WITH_TIMEOUT((again->poll(), again->view().canAnswer), kPatience_ms);
    QVERIFY(!again->view().practice); // it was practised
}

/// Language, masking and the moments of trial and answer, in every table that they belong in.
void TestLiveStudy::whatASittingNotesIsExported() {
    Site site;
    {
        const auto live = site.sit();
        live->setMasking(session::TrialCircumstances::kMaskingNoise);
        QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
        live->beginAnswer();
        QTest::qWait(300);
        live->poll();
        QVERIFY(live->answer(0));
        QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->numbers().scored + live->numbers().spoiled == 1),
                                 kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
        live->setMasking(session::TrialCircumstances::kMaskingOff); // in the middle of a trial
        QVERIFY(live->answer(1));
        QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->numbers().scored + live->numbers().spoiled == 2),
                                 kPatience_ms);
        live->stop();
        QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->finished()), kPatience_ms);
    }
    const auto trials = storedTrials(site);
    QTemporaryDir folder;
    auto connection = site.fixture.database->openReader();
    database::StudyReader reader(**connection, site.actor);
    const QString into = folder.filePath(QStringLiteral("out"));
    QVERIFY(session::exportStudyCsv(reader, site.study, into.toStdString()));
    const auto cells = [&](const char* table, const char* column) {
        QFile file(into + QLatin1Char('/') + QLatin1String(table));
        QStringList out;
        if (!file.open(QIODevice::ReadOnly))
            return out;
        QList<QByteArray> lines = file.readAll().trimmed().split('\n');
        const qsizetype at = lines.takeFirst().split(',').indexOf(column);
        for (const QByteArray& line : lines)
            out << QString::fromUtf8(line.split(',').value(at));
        return out;
    };
    QCOMPARE(cells("trials.csv", "language").mid(0, 2), QStringList({"de", "de"}));
    QCOMPARE(cells("trials.csv", "masking_sound").mid(0, 2), QStringList({"pink_noise", "changed"}));
    QCOMPARE(cells("trials.csv", "sitting").mid(0, 2), QStringList({"1", "1"}));
    QCOMPARE(cells("trials.csv", "onset").front().toDouble(),
             1e-3 * static_cast<double>(trials[0].firstTick));
    QCOMPARE(cells("trials.csv", "offset").front().toDouble(),
             1e-3 * static_cast<double>(trials[0].lastTick));
    const double began = cells("trials.csv", "response_onset").front().toDouble(),
                 took = cells("trials.csv", "response_duration").front().toDouble();
    QVERIFY2(took > 0.1 && std::abs(began + took - 1e-3 * static_cast<double>(trials[0].lastTick)) < 1e-9,
             qPrintable(QString::number(took)));
    QCOMPARE(cells("runs.csv", "language"), QStringList({"de"}));
    QVERIFY(cells("runs.csv", "masking_sound").front().contains(QStringLiteral("pink_noise")));
}

/// A stop does not wait for the window's next look, which may be long in coming.
void TestLiveStudy::forceIsStoppedAtOnceAndRearmed() {
    Site site;
    const auto live = site.sit();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
    live->stopForce();
    QCOMPARE(live->view().state, View::stopped);
    QVERIFY(!live->view().canAnswer && !live->answer(0));
    QTRY_VERIFY_WITH_TIMEOUT((live->training().beat(), live->training().display().latest().paused),
                             kPatience_ms);
    live->resume(); // that takes more
    live->poll();
    QCOMPARE(live->view().state, View::stopped);
    live->rearm();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
}

void TestLiveStudy::aScoredTrialIsToldWhereTheDesignSaysSo() {
    Site site(false, [](psychophysics::StudyDesign& design) {
        design.trial.feedback = true;
        design.trial.practiceTrials = 0;
        design.trial.betweenTrials_s = 0.0;
        design.fidelity.lateTicks = 1.0; // on a busy machine, too
    });
    const auto live = site.sit();
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms);
    QVERIFY(live->answer(2).has_value());
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->numbers().scored == 1), kPatience_ms);
    const session::LiveStudyView told = live->view();
    QVERIFY(told.state == View::feedback && !told.practice && !told.mayTakeBack); // it counts
    QCOMPARE(told.right,
             std::optional(psychophysics::correctAnswer(psychophysics::Task::rank3,
                                                        storedTrials(site).front().arrangement) == 2));
    QTRY_VERIFY_WITH_TIMEOUT((live->poll(), live->view().canAnswer), kPatience_ms); // for a while
    QVERIFY(!live->view().right);
}

QTEST_MAIN(TestLiveStudy)
#include "test_live_study.moc"
