// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/fidelity_meter.h"
#include "session/study/rendered_run.h"
#include "support/study_designs.h"

#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace chiron;

namespace {

constexpr double kReference_N_per_m = 150.0;

psychophysics::StudyDesign adjustmentStudy() {
    auto design = testing::rank3Study();
    psychophysics::Condition& condition = design.conditions.front();
    condition.task = psychophysics::Task::adjustment;
    condition.stimulus.differences = testing::spaced(-0.2, 0.2, 81);
    condition.procedures = {psychophysics::ConstantSpec{.levels = {-0.2, 0.2}, .repeats = 3}};
    return design;
}

/// One contact of 0.4 s with a spring at the right place, pulled out and back.
void pull(session::FidelityMeter& meter, double stiffness_N_per_m, int candidate, std::uint64_t& tick) {
    session::FidelitySample sample;
    sample.phase = core::TrialPhase::running;
    sample.full = true;
    sample.candidate = static_cast<std::uint16_t>(candidate + 1);
    sample.arrangement = 1;
    sample.touched = 3;
    for (int i = 0; i < 400; ++i) {
        const double phase = 2.0 * 3.14159265358979 * i / 400.0;
        sample.tick = ++tick;
        sample.now_ns = static_cast<std::int64_t>(tick) * 1'000'000;
        sample.place = 2;
        sample.displacement_m = 0.001 + 0.003 * (1.0 - std::cos(phase));
        sample.velocity_m_per_s = {0.0, 0.0, 0.047 * std::sin(phase)};
        sample.commanded_N = {0.0, 0.0, -stiffness_N_per_m * sample.displacement_m};
        meter.add(sample);
    }
    sample.place = 0;
    sample.tick = ++tick;
    sample.now_ns += 1'000'000;
    meter.add(sample);
}

session::TrialFidelity measured(double secondStiffness_N_per_m) {
    simulation::ComparisonParameters parameters;
    parameters.attribute = simulation::ComparedAttribute::stiffness;
    parameters.places = 2;
    parameters.adjusts = true;
    parameters.values = {{150.0, 300.0, 600.0}, {150.0, 165.0, 181.5}};
    parameters.arrangements = {{0, 1, -1}};
    session::FidelityMeter meter(parameters, {}, true);
    meter.begin({150.0, 300.0});
    std::uint64_t tick = 0;
    pull(meter, 300.0, 0, tick);
    pull(meter, secondStiffness_N_per_m, 1, tick); // the level was turned down in between
    return meter.finish();
}

} // namespace

class TestAdjustment : public QObject {
    Q_OBJECT
private slots:
    void fidelityIsOfTheLevelThatWasSet() {
        const auto good = measured(165.0);
        QVERIFY2(good.outside.empty(), good.outside.c_str());
        QCOMPARE(good.places[1].asked, 165.0);
        QVERIFY(std::abs(good.places[1].rendered - 165.0) < 1e-4); // the regression's ridge takes 4e-6
        QCOMPARE(measured(300.0).outside, std::string("stiffness_error")); // a renderer that did not follow
    }
    /// From the first row of the table on, and of whichever object.
    void everyLevelOfTheDialIsOne() {
        simulation::ComparisonParameters parameters;
        parameters.attribute = simulation::ComparedAttribute::stiffness;
        parameters.places = 2;
        parameters.adjusts = true;
        parameters.values = {{150.0, 300.0, 600.0}, {150.0, 165.0, 181.5}};
        parameters.arrangements = {{0, 2, -1}};
        session::FidelityMeter meter(parameters, {}, true);
        meter.begin({150.0, 181.5});
        std::uint64_t tick = 0;
        pull(meter, 181.5, 1, tick);
        pull(meter, 600.0, 0, tick);
        const auto fidelity = meter.finish();
        QCOMPARE(fidelity.places[1].asked, 600.0);
        QVERIFY2(std::abs(fidelity.places[1].rendered - 600.0) < 1e-3,
                 qPrintable(QString::number(fidelity.places[1].rendered)));
    }
    /// Through the rendering: a participant turns a dial by what the hand felt, from both ends of the table.
    void participantTurnsTheDial() {
        session::RenderedRunRequest request;
        request.design = adjustmentStudy();
        request.condition = "main";
        request.observer = {.weber = 0.01, .lapse = 0.0};
        request.seed = 3;
        const auto run = session::runRendered(request);
        QVERIFY2(run, run ? "" : run.error().message.c_str());
        QVERIFY(run->completed);
        const auto& table = request.design.conditions.front().stimulus.differences;
        for (const auto& trial : run->trials) {
            QVERIFY2(trial.spoiled.empty(), (trial.spoiled + " " + trial.fidelityJson).c_str());
            QVERIFY(trial.value);
            const double set = std::log10(*trial.value / kReference_N_per_m);
            QVERIFY2(std::abs(set) < 0.04, qPrintable(QString::number(set)));
            QVERIFY(std::any_of(table.begin(), table.end(),
                                [&](double d) { return std::abs(d - set) < 1e-9; })); // a level of the dial
        }
    }
    /// What is set follows what is felt: with a renderer of a constant force both objects feel alike wherever
    /// the dial stands.
    void aDialThatChangesNothingIsLeftAlone() {
        session::RenderedRunRequest request;
        request.design = adjustmentStudy();
        request.design.fidelity.stiffnessError = 10.0;
        request.condition = "main";
        request.observer = {.weber = 0.001, .lapse = 0.0};
        request.control = simulation::ComparisonControl::constant;
        const auto run = session::runRendered(request);
        QVERIFY(run);
        for (const auto& trial : run->trials)
            if (trial.value)
                QVERIFY(std::abs(std::log10(*trial.value / kReference_N_per_m) - trial.difference) < 0.06);
    }
};

QTEST_MAIN(TestAdjustment)
#include "test_adjustment.moc"
