// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "support/insertion_in.h"
#include "traces.h"

#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

/// Trials through a canal, made from formulas.
namespace traces {

using chiron::scoring::InsertionSeries;
using chiron::simulation::ProcedureStage;

/// What one sample of a canal says, as a function of time (SI).
struct CanalSample {
    double s_m = 0.0;
    double offset_m = 0.0;
    double alignment_rad = 0.0;
    double lateral_N = 0.0;
    double axialTorque_Nm = 0.0;
    ProcedureStage stage = ProcedureStage::insertion;
};

/// A trial of `duration_s` at `step_s` whose tip moves along x as deep as it is in, with a canal of 110 mm,
/// its bend at 40 mm and a limit of 2 N.
inline TrialTrace canalTrial(double duration_s, double step_s,
                             const std::function<CanalSample(double)>& canal) {
    TrialTrace trial;
    trial.tools.push_back(
        sampled(duration_s, step_s, [&](double t) { return Vec3(canal(t).s_m, 0.0, 0.0); }));
    InsertionSeries series;
    for (const double t : trial.tools.front().t_s) {
        const CanalSample sample = canal(t);
        series.s_m.push_back(sample.s_m);
        series.offset_m.push_back(sample.offset_m);
        series.alignment_rad.push_back(sample.alignment_rad);
        series.lateral_N.push_back(sample.lateral_N);
        series.axialTorque_Nm.push_back(sample.axialTorque_Nm);
        series.stage.push_back(static_cast<std::uint8_t>(sample.stage));
    }
    series.length_m = 0.110;
    series.bend_m = 0.040;
    series.goal_m = 0.080;
    series.lateralLimit_N = 2.0;
    trial.own = std::make_shared<InsertionSeries>(std::move(series));
    return trial;
}

inline SessionTrace canalSession(std::vector<TrialTrace> trials) {
    SessionTrace trace;
    trace.exercise = "urethra_insertion";
    for (TrialTrace& trial : trials) {
        trial.trial = static_cast<int>(trace.trials.size());
        trace.trials.push_back(std::move(trial));
    }
    return trace;
}

inline SessionTrace canalSession(TrialTrace trial) {
    std::vector<TrialTrace> one;
    one.push_back(std::move(trial));
    return canalSession(std::move(one));
}

/// Straight in from -10 mm to 90 mm at 10 mm/s.
inline TrialTrace straightIn(const std::function<void(CanalSample&, double)>& with = {}) {
    return canalTrial(10.0, 0.001, [&](double t) {
        CanalSample sample;
        sample.s_m = -0.010 + 0.010 * t;
        if (with)
            with(sample, t);
        return sample;
    });
}

/// The first trial as metrics see it.
inline TrialTrace onGrids(const TrialTrace& trial) {
    return chiron::scoring::onStoredGrids(canalSession(trial))->trials.front();
}

} // namespace traces
