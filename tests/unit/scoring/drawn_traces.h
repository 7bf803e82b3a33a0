// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "palpation_traces.h"

#include "core/random.h"
#include "modules/exercises/palpation/cues/report_word.h"
#include "scoring/trace.h"
#include "support/insertion_in.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

/// Trials that were drawn so that much happens in them, often just at a limit, and what may lack of them.
namespace chiron::tests {

using core::Vec3;
using scoring::InsertionSeries;
using scoring::NamedValue;
using scoring::QuantityTrace;
using scoring::SessionTrace;
using scoring::TargetTruth;
using scoring::ToolTrace;
using scoring::TrialTrace;

inline constexpr int kSamples = 2400; ///< at 500 Hz

/// One of these for some time, then another: what is drawn stays long enough to count.
class Stretches {
public:
    Stretches(std::uint64_t seed, std::vector<double> values, int least, int most)
        : m_random(seed), m_values(std::move(values)), m_least(least), m_most(most) {}
    double next() {
        if (m_left-- <= 0) {
            m_value = m_values[m_random.below(m_values.size())];
            m_left =
                m_least + static_cast<int>(m_random.below(static_cast<std::uint64_t>(m_most - m_least + 1)));
        }
        return m_value;
    }

private:
    core::Random m_random;
    std::vector<double> m_values;
    int m_least, m_most, m_left = 0;
    double m_value = 0.0;
};

/// Moves, rests, presses, pauses.
inline ToolTrace tool(std::uint64_t seed) {
    ToolTrace trace;
    core::Random random(seed);
    Stretches speed(seed + 1, {0.0, 0.004, 0.005, 0.02, 0.06, -0.03}, 40, 260),
        force(seed + 2, {0.0, 0.01, 0.02, 0.03, 0.5, 0.8, 1.4, 1.5, 1.501, 2.5, 4.0, 4.2}, 5, 120);
    Stretches bits(seed + 3, {0.0, 0.0, 0.0, 1.0, 2.0, 4.0, 6.0}, 30, 200),
        pause(seed + 4, {0.0, 0.0, 0.0, 0.0, 1.0}, 100, 240);
    double x = 0.0, t = 0.3;
    for (int i = 0; i < kSamples; ++i) {
        t += i % 700 == 650 ? 0.4 : 0.002;
        x += 0.002 * speed.next();
        const double f = force.next();
        trace.t_s.push_back(t);
        trace.p_WT_m.push_back(
            Vec3(x, 0.01 * std::sin(2.0 * t), 0.002 * std::cos(5.0 * t) + 1e-5 * random.normal()));
        trace.tissue_N.push_back(f * Vec3(0.0, 0.6, 0.8));
        trace.commanded_N.push_back(std::min(f, 2.0) * Vec3(0.0, 0.6, 0.8));
        trace.measured_N.push_back(std::min(f, 2.1) * Vec3(0.1, 0.6, 0.8));
        trace.tissueTorque_Nm.push_back(Vec3(0.0, 0.002 * f, -0.001 * f));
        trace.q_WT.push_back(core::Quat::Identity());
        trace.contact.push_back(static_cast<std::uint8_t>(bits.next()));
        trace.paused.push_back(pause.next() > 0.5 ? 1 : 0);
    }
    return trace;
}

inline InsertionSeries canal(std::uint64_t seed, const std::vector<double>& t_s) {
    InsertionSeries series;
    Stretches lateral(seed, {0.0, 0.4, 1.59, 1.6, 1.61, 2.0, 2.001, 2.5, 3.9, 4.0, 4.1}, 4, 90),
        offset(seed + 1, {0.0, 0.0004, 0.002, 0.0031}, 10, 100),
        turned(seed + 2, {0.0, 0.05, 0.2, 0.4}, 10, 100);
    Stretches twist(seed + 3, {0.0, 0.001, 0.0043}, 10, 100),
        back(seed + 4, {0.00006, 0.00006, 0.00006, 0.00009, -0.00005, -0.00002}, 8, 40);
    double s = -0.004;
    for (std::size_t i = 0; i < t_s.size(); ++i) {
        s = std::min(s + back.next(), 0.115);
        const int stage = s < 0.0 ? 0 : i < 1700 ? 1 : i < 2000 ? 2 : i < 2300 ? 3 : 4;
        series.s_m.push_back(std::round(1e6 * s) / 1e6);
        series.offset_m.push_back(offset.next());
        series.alignment_rad.push_back(turned.next());
        series.lateral_N.push_back(lateral.next());
        series.axialTorque_Nm.push_back(twist.next());
        series.stage.push_back(static_cast<std::uint8_t>(stage));
    }
    series.length_m = 0.110;
    series.bend_m = 0.040;
    series.goal_m = 0.080;
    series.lateralLimit_N = 2.0;
    series.landmarkSeen_s = {t_s[1800], std::numeric_limits<double>::quiet_NaN(), t_s[1900], t_s[1799]};
    return series;
}

inline void addDrawn(TrialTrace& trial, const char* id, std::uint64_t seed, std::vector<double> values,
                     int least = 20, int most = 200) {
    Stretches drawn(seed, std::move(values), least, most);
    QuantityTrace quantity{id, {}};
    for (int i = 0; i < kSamples; ++i)
        quantity.values.push_back(drawn.next());
    trial.quantities.push_back(std::move(quantity));
}

/// What scenes of tubes and objects record.
inline void addScene(TrialTrace& trial, std::uint64_t seed) {
    addDrawn(trial, "step", seed, {1, 2, 3, 3, 3, 4, 9, 5, 6, 7, 8}, 60, 220);
    addDrawn(trial, "tension_N", seed + 1, {0.0, 0.4, 0.85, 0.849, 1.0, 1.15, 1.1501, 1.4});
    addDrawn(trial, "stretch_m", seed + 2, {0.0, 0.01, 0.018, 0.0195, 0.02, 0.0315, 0.03151, 0.04});
    addDrawn(trial, "grip_1", seed + 3, {0.0, 0.0, 1.0, 0.5}, 20, 120);
    addDrawn(trial, "grip_0", seed + 4, {0.0, 1.0}, 20, 120);
    addDrawn(trial, "fold_open", seed + 5, {0.0, 1.0, 0.5}, 50, 300);
    addDrawn(trial, "retraction_N", seed + 6, {0.0, 0.3, 0.2999, 0.6, 0.6001, 0.9});
    addDrawn(trial, "held", seed + 7, {0.0, 0.0, 1.0, 2.0}, 50, 300);
    addDrawn(trial, "squeeze_N", seed + 8, {0.0, 0.5, 1.5, 1.501, 2.0});
    addDrawn(trial, "held_error_m", seed + 9, {0.0, 0.001, -0.002});
    addDrawn(trial, "prediction_error_m", seed + 10, {0.0, 0.003, -0.004});
    addDrawn(trial, "coverage", seed + 11, {0.2, 0.5, 0.73});
    for (const char* id : {"body_0_x_m", "body_0_y_m", "body_1_x_m", "body_1_y_m"})
        addDrawn(trial, id, ++seed + 20, {0.013, 0.024, 0.02, 0.01});
    trial.truth = {{"over_stretch_m", 0.0315}, {"target_N", 1.0},          {"band_N", 0.15},
                   {"retraction_low_N", 0.3},  {"retraction_high_N", 0.6}, {"target_x_m", 0.01},
                   {"target_y_m", 0.02},       {"squeeze_limit_N", 1.5},   {"task", 1.0},
                   {"objects", 2.0},           {"heaviest", 1.0},          {"band_low_N", 0.8},
                   {"band_high_N", 2.5}};
}

inline SessionTrace drawn() {
    SessionTrace trace;
    trace.exercise = "drawn";
    trace.forceLimit_N = 1.5;
    trace.plannedTrials = 5;
    for (int k = 0; k < 4; ++k) {
        const auto seed = static_cast<std::uint64_t>(100 * k + 7);
        TrialTrace trial;
        trial.trial = k;
        trial.tools = {tool(seed), tool(seed + 40)};
        trial.own = std::make_shared<InsertionSeries>(canal(seed + 60, trial.tools[0].t_s));
        addScene(trial, seed + 70);
        trial.marked = k != 2;
        trial.timedOut = k == 2;
        trial.markInContact = k != 1;
        trial.completed = k % 2 == 0;
        trial.failed = k == 3;
        trial.p_WMark_m = trial.tools[0].p_WT_m.back() + Vec3(0.002 * k, -0.001, 0.0);
        trial.target = TargetTruth{0.01 - 0.004 * k, 0.003 * k, 0.02};
        trace.trials.push_back(std::move(trial));
    }
    return trace;
}

/// One after the other a trial with nothing but its samples, and all trials with something gone.
inline std::vector<std::pair<const char*, std::function<void(SessionTrace&)>>> changes() {
    const auto each = [](auto change) {
        return [change](SessionTrace& trace) {
            std::for_each(trace.trials.begin(), trace.trials.end(), change);
        };
    };
    const auto without = [&](const char* id) {
        return [id](SessionTrace& trace) {
            std::erase_if(trace.trials[1].quantities, [&](const QuantityTrace& q) { return q.id == id; });
        };
    };
    const auto untrue = [&](const char* id) {
        return [id](SessionTrace& trace) {
            std::erase_if(trace.trials[1].truth, [&](const NamedValue& v) { return v.id == id; });
        };
    };
    std::vector<std::pair<const char*, std::function<void(SessionTrace&)>>> all{
        {"as drawn", [](SessionTrace&) {}},
        {"one trial", [](SessionTrace& trace) { trace.trials.resize(1); }},
        {"two trials", [](SessionTrace& trace) { trace.trials.resize(2); }},
        {"no trial", [](SessionTrace& trace) { trace.trials.clear(); }},
        {"no tool",
         [](SessionTrace& trace) {
             trace.trials[1].tools.clear();
             trace.trials[1].own.reset();
             trace.trials[1].quantities.clear();
         }},
        {"two samples", each([](TrialTrace& trial) {
             trial.own.reset();
             trial.quantities.clear();
             for (ToolTrace& one : trial.tools)
                 one = ToolTrace{{0.0, 0.01},
                                 {Vec3(0, 0, 0), Vec3(0.01, 0, 0)},
                                 {Vec3(0, 0, 1), Vec3(0, 0, 2)},
                                 {},
                                 {},
                                 {0, 0},
                                 {},
                                 {},
                                 {},
                                 {}};
         })},
        {"forces not known", [](SessionTrace& trace) { trace.trials[2].forcesKnown = false; }},
        {"unfinished", [](SessionTrace& trace) { trace.trials[2].unfinished = true; }},
        {"all unfinished", each([](TrialTrace& trial) { trial.unfinished = true; })},
        {"more than planned", [](SessionTrace& trace) { trace.plannedTrials = 3; }},
        {"not known how many", [](SessionTrace& trace) { trace.plannedTrials = 0; }},
        {"no apex", [](SessionTrace& trace) { trace.trials[1].target.reset(); }},
        {"no canal", [](SessionTrace& trace) { trace.trials[1].own.reset(); }},
        {"nothing to be done",
         [](SessionTrace& trace) {
             trace.trials[1].own.reset();
             trace.trials[1].quantities.clear();
         }},
        {"no torques", [](SessionTrace& trace) { trace.trials[1].tools[0].tissueTorque_Nm.clear(); }},
        {"no contact bits", each([](TrialTrace& trial) { trial.tools[0].contact.clear(); })},
        {"no landmarks", each([](TrialTrace& trial) { insertionIn(trial).landmarkSeen_s.clear(); })},
        {"never inside", each([](TrialTrace& trial) {
             insertionIn(trial).s_m.assign(insertionIn(trial).s_m.size(), -0.001);
         })},
        {"never inspected", each([](TrialTrace& trial) {
             std::vector<std::uint8_t>& stage = insertionIn(trial).stage;
             std::replace(stage.begin(), stage.end(), std::uint8_t{2}, std::uint8_t{1});
         })},
        {"never held", each([](TrialTrace& trial) {
             std::replace(trial.quantities[0].values.begin(), trial.quantities[0].values.end(), 3.0, 2.0);
         })},
        {"nothing taken", each([](TrialTrace& trial) {
             for (QuantityTrace& q : trial.quantities)
                 if (q.id == "held")
                     q.values.assign(q.values.size(), 0.0);
         })},
        {"all paused", each([](TrialTrace& trial) {
             for (ToolTrace& one : trial.tools)
                 one.paused.assign(one.paused.size(), 1);
         })},
        {"still", each([](TrialTrace& trial) {
             for (ToolTrace& one : trial.tools)
                 one.p_WT_m.assign(one.p_WT_m.size(), Vec3(0.01, 0, 0));
         })},
        {"no force", each([](TrialTrace& trial) {
             for (ToolTrace& one : trial.tools)
                 one.tissue_N.assign(one.tissue_N.size(), Vec3::Zero());
         })},
        {"there and back", each([](TrialTrace& trial) {
             for (ToolTrace& one : trial.tools)
                 one.p_WT_m.back() = one.p_WT_m.front();
         })},
        {"to a mark", each([](TrialTrace& trial) {
             trial.truth.push_back({"mark_m", 0.02});
             trial.truth.push_back({"mark_tolerance_m", 0.002});
             std::erase_if(trial.truth, [](const NamedValue& v) { return v.id == "target_N"; });
         })},
        {"slow", each([](TrialTrace& trial) {
             for (ToolTrace& one : trial.tools)
                 for (double& t : one.t_s)
                     t *= 6.0;
         })}};
    for (const char* id : {"step", "tension_N", "stretch_m", "grip_1", "fold_open", "retraction_N", "held",
                           "squeeze_N", "held_error_m", "prediction_error_m", "coverage", "body_1_x_m"})
        all.emplace_back(id, without(id));
    for (const char* id : {"over_stretch_m", "target_N", "band_N", "retraction_low_N", "target_x_m",
                           "squeeze_limit_N", "task", "objects", "heaviest", "band_low_N", "band_high_N"})
        all.emplace_back(id, untrue(id));
    return all;
}

/// Of a palpation: lumps, findings near the edges of reach, regions and the area, said or not said.
inline std::vector<TrialTrace> palpated() {
    std::vector<TrialTrace> trials;
    trials.push_back(MadeTrial({{-0.02, -0.02, 0.0075, 5}, {0.0, 0.0, 0.004, 2}, {0.02, 0.015, 0.015, 3}})
                         .found(0, -0.015, -0.02, 5, 4, 80)
                         .found(1, 0.012, 0.0, 3, 2, 50)
                         .found(2, 0.02, 0.0301, 1, 3)
                         .found(3, 0.029, -0.029, 2)
                         .covered(0.9));
    trials.push_back(MadeTrial({{0.01, 0.01, 0.0075, 1}, {-0.01, 0.01, 0.0075, 4}}, 2)
                         .found(0, -0.0099, 0.01, 4, 4, 60)
                         .found(1, 0.0101, 0.01, 0, 1)
                         .found(2, -0.03, 0.03)
                         .found(3, 0.031, 0.0, 5)
                         .press(0, 20, 90, 1.0)
                         .press(1, 60, 120, 2.6)
                         .press(0, 150, 151, 0.02)
                         .pause(200, 230)
                         .timedOut());
    trials.push_back(MadeTrial({{0.0, 0.0, 0.0075, 3}, {0.02, 0.0, 0.0075, 3}, {-0.02, 0.0, 0.0075, 5}})
                         .found(0, 0.0, 0.001, 2, 3, 75)
                         .found(1, 0.02, 0.001, 2, 3, 75)
                         .found(2, -0.02, 0.002, 2, 2, 90)
                         .say(simulation::ReportField::remove, 1, 1)
                         .at(250)
                         .say(simulation::ReportField::done, 0)
                         .covered(0.4));
    trials.push_back(MadeTrial().found(0, 0.01, 0.0, 1));
    trials.push_back(MadeTrial(std::vector<MadeLump>{{0.0, 0.0, 0.0075, 2}}).press(0, 0, 300, 4.5));
    return trials;
}

} // namespace chiron::tests
