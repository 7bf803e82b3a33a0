// SPDX-License-Identifier: GPL-3.0-or-later
// What follows from a design by itself: what a device leaves of its tables, in which order objects stand, how
// long trials took, who is still to come.
#include "psychophysics/planning/run_simulator.h"
#include "session/study/people_to_come.h"
#include "session/study/presentation_order.h"
#include "session/study/study_limits.h"
#include "session/study/trial_clock.h"
#include "simulation/attributes/object_attributes.h"

#include "core/units.h"

#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

using namespace chiron;
using psychophysics::Attribute;
using psychophysics::Task;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

devices::DeviceDescriptor device() {
    devices::DeviceDescriptor made;
    made.rendersForce = true;
    made.inProcess = false;
    made.period_us = 1500;
    made.maximumForce_N = 3.0;
    made.maximumDamping_Ns_per_m = 25.0;
    return made;
}

psychophysics::Condition condition(Attribute attribute, double reference, Task task = Task::twoAfc) {
    psychophysics::Condition made;
    made.task = task;
    made.stimulus.attribute = attribute;
    made.stimulus.reference = reference;
    made.stimulus.differences = {0.01, 0.02, 0.05, 0.1, 0.2};
    return made;
}

/// What is left on a device whose limit lies just at the value of the third difference, or just under it.
session::LimitedTable atThird(Attribute attribute, double session::RenderingLimits::*limit, double perValue,
                              double beside, double share) {
    const psychophysics::Condition made = condition(attribute, 2.0);
    session::RenderingLimits limits{kInfinite, kInfinite, kInfinite, 0.0, false};
    limits.*limit = (2.0 * std::pow(10.0, 0.05) * perValue + beside) * share;
    return session::limitedTable(made, limits);
}

} // namespace

class TestStudyLimits : public QObject {
    Q_OBJECT
private slots:
    void aDeviceRendersSoMuch();
    void theDelayIsTheMeasuredOne();
    void aTableEndsWhereTheDeviceDoes();
    void theLargestMultipleCounts();
    void nothingIsLeftWithoutTheReference();
    void everyBlockHoldsEachArrangement();
    void whatIsAgainIsDrawnByItself();
    void trialsAtMostAreTheProcedures();
    void aTrialsClockLeavesPausesOut();
    void whoIsStillToCome();
};

void TestStudyLimits::aDeviceRendersSoMuch() {
    const auto limits = session::renderingLimits(device(), 0.004);
    QCOMPARE(limits.delay_s, 0.004);
    QVERIFY(std::abs(limits.largestStiffness_N_per_m - 2.0 / (0.0005 + 0.004)) < 1e-9);
    QCOMPARE(limits.largestViscosity_Ns_per_m, 25.0);
    QCOMPARE(limits.largestForce_N, 3.0);
    QVERIFY(!limits.measured);
    QCOMPARE(session::renderingLimits(device()).delay_s, 0.0015); // one period
    devices::DeviceDescriptor strong = device();
    strong.maximumForce_N = 9.0;
    QCOMPARE(session::renderingLimits(strong).largestForce_N, 4.0); // the site's cap
    strong.maximumForce_N = 0.0;                                    // not stated
    QCOMPARE(session::renderingLimits(strong).largestForce_N, 4.0);
    strong.inProcess = true;
    QCOMPARE(session::renderingLimits(strong).delay_s, 0.0);
    QVERIFY(std::abs(session::renderingLimits(strong).largestStiffness_N_per_m - 4000.0) < 1e-9);
    strong.rendersForce = false;
    const auto none = session::renderingLimits(strong, 0.004);
    QVERIFY(none.largestStiffness_N_per_m == kInfinite && none.largestViscosity_Ns_per_m == kInfinite &&
            none.largestForce_N == kInfinite && none.delay_s == 0.0);
}

void TestStudyLimits::theDelayIsTheMeasuredOne() {
    QCOMPARE(session::statedDelay_s(device()), 0.003); // two periods
    const auto measured = session::limitsAt(device(), 0.0007);
    QVERIFY(measured.measured && measured.delay_s == 0.0007);
    for (const std::optional<double>& none :
         {std::optional<double>(), std::optional(0.0), std::optional(-0.001), std::optional(std::nan("")),
          std::optional(kInfinite)}) {
        const auto stated = session::limitsAt(device(), none);
        QVERIFY(!stated.measured && stated.delay_s == 0.003);
    }
    devices::DeviceDescriptor inside = device();
    inside.inProcess = true;
    QCOMPARE(session::statedDelay_s(inside), 0.0);
}

void TestStudyLimits::aTableEndsWhereTheDeviceDoes() {
    using L = session::RenderingLimits;
    const double damping = simulation::ObjectAttributes{}.damping_Ns_per_m;
    const auto check = [](const session::LimitedTable& at, const session::LimitedTable& under,
                          const std::string& why) {
        QVERIFY(at.candidates == 3 && at.limit == 0.05 && at.why == why);
        QVERIFY(under.candidates == 2 && under.limit == 0.02 && under.why == why);
    };
    check(atThird(Attribute::stiffness, &L::largestStiffness_N_per_m, 1.0, 0.0, 1.0 + 1e-9),
          atThird(Attribute::stiffness, &L::largestStiffness_N_per_m, 1.0, 0.0, 1.0 - 1e-9), "stiffness");
    const double weight = core::kStandardGravity / 0.75; // a quarter is left for lifting it
    check(atThird(Attribute::mass, &L::largestForce_N, weight, 0.0, 1.0 + 1e-9),
          atThird(Attribute::mass, &L::largestForce_N, weight, 0.0, 1.0 - 1e-9), "weight");
    check(atThird(Attribute::viscosity, &L::largestViscosity_Ns_per_m, 1.0, damping, 1.0 + 1e-9),
          atThird(Attribute::viscosity, &L::largestViscosity_Ns_per_m, 1.0, damping, 1.0 - 1e-9),
          "viscosity");
    psychophysics::Condition damped = condition(Attribute::viscosity, 2.0);
    damped.stimulus.fixed["damping_Ns_per_m"] = 3.0;
    L limits{kInfinite, 2.0 * std::pow(10.0, 0.05) + 3.0 + 1e-9, kInfinite, 0.0, false};
    QCOMPARE(session::limitedTable(damped, limits).candidates, 3);
    for (const Attribute attribute :
         {Attribute::deformation, Attribute::roughness, Attribute::friction}) { // nothing limits these
        const auto all = session::limitedTable(condition(attribute, 2.0), {1.0, 1.0, 1.0, 0.0, false});
        QVERIFY(all.candidates == 5 && all.limit == kInfinite && all.why.empty());
    }
}

void TestStudyLimits::theLargestMultipleCounts() {
    session::RenderingLimits limits{2.0 * std::pow(10.0, 0.1) + 1e-9, kInfinite, kInfinite, 0.0, false};
    QCOMPARE(session::limitedTable(condition(Attribute::stiffness, 2.0), limits).limit, 0.1);
    QCOMPARE(session::limitedTable(condition(Attribute::stiffness, 2.0, Task::rank3), limits).limit,
             0.05); // one of three lies twice as high
    psychophysics::Condition both = condition(Attribute::stiffness, 2.0);
    both.stimulus.differences = {-0.2, -0.1, 0.1, 0.2}; // below the reference nothing is too stiff
    const auto left = session::limitedTable(both, limits);
    QVERIFY(left.candidates == 3 && left.limit == 0.2 && left.why == "stiffness");
}

void TestStudyLimits::nothingIsLeftWithoutTheReference() {
    const auto none =
        session::limitedTable(condition(Attribute::stiffness, 2.0), {1.9, kInfinite, kInfinite, 0.0, false});
    QVERIFY(none.candidates == 0 && none.limit == 0.0 && none.why == "reference");
    psychophysics::Condition onStiff =
        condition(Attribute::friction, 0.5); // whatever is compared, it is felt on a spring
    onStiff.stimulus.fixed["stiffness_N_per_m"] = 500.0;
    QCOMPARE(session::limitedTable(onStiff, {499.0, kInfinite, kInfinite, 0.0, false}).why,
             std::string("reference"));
    QVERIFY(session::limitedTable(onStiff, {500.0, kInfinite, kInfinite, 0.0, false}).why.empty());
}

void TestStudyLimits::everyBlockHoldsEachArrangement() {
    for (const Task task :
         {Task::rank3, Task::twoAfc, Task::threeAfc, Task::oddity, Task::sameDifferent, Task::yesNo}) {
        const int count = static_cast<int>(psychophysics::arrangements(task).size());
        std::set<std::vector<int>> orders;
        for (const std::uint64_t seed : {1, 2, 3})
            for (const int procedure : {0, 1})
                for (int block = 0; block < 4; ++block) {
                    std::vector<int> order;
                    for (int i = 0; i < count; ++i)
                        order.push_back(session::balancedArrangement(
                            task, seed, {procedure, block * count + i, 100 + i, 0, false}));
                    orders.insert(order);
                    std::sort(order.begin(), order.end());
                    for (int i = 0; i < count; ++i)
                        QCOMPARE(order[static_cast<std::size_t>(i)], i);
                }
        QVERIFY(orders.size() >
                (count > 2 ? 4U : 1U)); // each block, procedure and seed in an order of its own
    }
    // The first place is as often any of them.
    std::array<int, 6> first{};
    for (std::uint64_t seed = 0; seed < 6000; ++seed)
        ++first[static_cast<std::size_t>(session::balancedArrangement(Task::rank3, seed, {}))];
    for (const int times : first)
        QVERIFY(times > 850 && times < 1150);
}

void TestStudyLimits::whatIsAgainIsDrawnByItself() {
    std::set<int> repeated, practised;
    bool differs = false;
    for (int ordinal = 0; ordinal < 60; ++ordinal) {
        const int again = session::balancedArrangement(Task::rank3, 5, {0, 3, ordinal, 1, false}),
                  practice = session::balancedArrangement(Task::rank3, 5, {0, 3, ordinal, 0, true});
        QVERIFY(again >= 0 && again < 6);
        QCOMPARE(practice, again); // by the presentation alone
        repeated.insert(again);
        practised.insert(practice);
        differs = differs || again != session::balancedArrangement(Task::rank3, 5, {0, 3, ordinal, 0, false});
    }
    QVERIFY(repeated.size() == 6 && practised.size() == 6 && differs);
}

void TestStudyLimits::trialsAtMostAreTheProcedures() {
    psychophysics::Condition made = condition(Attribute::stiffness, 2.0);
    psychophysics::ConstantSpec constant;
    constant.levels = {0.1, 0.2, 0.3};
    constant.repeats = 7;
    psychophysics::DescendingSpec descending;
    descending.levels = {0.2, 0.1};
    descending.repeats = 4;
    psychophysics::StaircaseSpec staircase;
    staircase.stop.trials = 30;
    made.procedures = {constant};
    QCOMPARE(session::trialsAtMost(made), 21);
    made.procedures = {constant, descending, staircase};
    QCOMPARE(session::trialsAtMost(made), 21 + 8 + 30);
    staircase.stop.trials = 0; // says nothing
    made.procedures = {constant, staircase};
    QCOMPARE(session::trialsAtMost(made), 0);
    made.procedures = {constant};
    for (const Task task :
         {Task::sameDifferent, Task::yesNo}) { // others beside those that show the difference
        made.task = task;
        int showing = 0, all = static_cast<int>(psychophysics::arrangements(task).size());
        for (int i = 0; i < all; ++i)
            showing += psychophysics::showsDifference(task, i) ? 1 : 0;
        QVERIFY(showing > 0 && showing < all);
        QCOMPARE(session::trialsAtMost(made), 21 * all / showing);
    }
}

void TestStudyLimits::aTrialsClockLeavesPausesOut() {
    session::TrialClock clock;
    clock.begin(1000);
    QVERIFY(clock.exploration_s() == 0.0 && clock.sinceContact_s() == 0.0 && clock.paused_s() == 0.0);
    const auto tick = [&](std::uint64_t at, bool paused, bool contact) {
        session::FidelitySample sample;
        sample.tick = at;
        sample.paused = paused ? 1 : 0;
        clock.take(sample, contact);
    };
    std::uint64_t at = 1000;
    for (int i = 0; i < 50; ++i)
        tick(++at, false, false);
    QVERIFY(std::abs(clock.sinceContact_s() - 0.050) < 1e-12); // of none: since it began
    for (int i = 0; i < 100; ++i)
        tick(++at, false, true);
    for (int i = 0; i < 30; ++i)
        tick(++at, true, true); // a contact within a pause is none
    for (int i = 0; i < 200; ++i)
        tick(++at, false, false);
    QVERIFY(clock.first() == 1000 && clock.last() == 1380);
    QVERIFY(std::abs(clock.exploration_s() - 0.350) < 1e-12);
    QVERIFY(std::abs(clock.sinceContact_s() - 0.200) < 1e-12);
    QVERIFY(std::abs(clock.paused_s() - 0.030) < 1e-12);
    tick(++at, false, true); // touched anew: pauses before it are over
    tick(++at, false, false);
    QVERIFY(std::abs(clock.sinceContact_s() - 0.001) < 1e-12 &&
            std::abs(clock.exploration_s() - 0.352) < 1e-12);
    clock.begin(5000);
    QVERIFY(clock.first() == 5000 && clock.exploration_s() == 0.0 && clock.paused_s() == 0.0);
}

void TestStudyLimits::whoIsStillToCome() {
    using State = database::ParticipantState;
    psychophysics::StudyDesign design;
    design.participantsPlanned = 6;
    database::StudySummary study;
    study.state = database::StudyState::frozen;
    std::vector<database::Participant> all;
    QCOMPARE(session::peopleToCome(design, study, all), 6);
    for (const auto& [state, simulated] : {std::pair{State::enrolled, false},
                                           {State::consented, false},
                                           {State::completed, false},
                                           {State::withdrawn, false},
                                           {State::enrolled, true},
                                           {State::completed, true}}) {
        database::Participant each;
        each.state = state;
        each.simulated = simulated;
        all.push_back(each);
    }
    QCOMPARE(session::peopleToCome(design, study, all),
             2 + 3); // three of six are enrolled, and one of those is done
    study.state = database::StudyState::closed;
    QCOMPARE(session::peopleToCome(design, study, all), 2);
    study.state = database::StudyState::frozen;
    design.participantsPlanned = 2; // more came than were planned
    QCOMPARE(session::peopleToCome(design, study, all), 2);
}

QTEST_APPLESS_MAIN(TestStudyLimits)
#include "test_study_limits.moc"
