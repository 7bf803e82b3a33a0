// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/procedure_spec.h"

namespace chiron::catalogue {

/// The keys of each kind of procedure, once for reading and for writing: visit(key, member).

template <class Stop, class Visit> void stopKeys(Stop& stop, Visit&& visit) {
    visit("trials", stop.trials);
    visit("minimum_trials", stop.minimumTrials);
    visit("reversals", stop.reversals);
    visit("sd", stop.sd);
    visit("reversals_and_trials", stop.reversalsAndTrials);
}

template <class Visit> void keysOf(psychophysics::StaircaseSpec& spec, Visit&& visit) {
    visit("start", spec.start);
    visit("up", spec.up);
    visit("down", spec.down);
    visit("steps_up", spec.stepsUp);
    visit("steps_down", spec.stepsDown);
    visit("step_ratio", spec.stepRatio);
    visit("step_type", spec.stepType);
    visit("initial_one_up_one_down", spec.initialOneUpOneDown);
    visit("reset_counters", spec.resetCounters);
    visit("new_step_at_reversal", spec.newStepAtReversal);
    visit("truncate", spec.truncate);
    visit("minimum", spec.minimum);
    visit("maximum", spec.maximum);
    visit("estimate_reversals", spec.estimateReversals);
    visit("stop", spec.stop);
}

template <class Visit> void keysOf(psychophysics::PestSpec& spec, Visit&& visit) {
    visit("start", spec.start);
    visit("target", spec.target);
    visit("wald_deviation", spec.waldDeviation);
    visit("step", spec.step);
    visit("smallest_step", spec.smallestStep);
    visit("largest_step", spec.largestStep);
    visit("minimum", spec.minimum);
    visit("maximum", spec.maximum);
    visit("stop", spec.stop);
}

template <class Visit> void keysOf(psychophysics::ConstantSpec& spec, Visit&& visit) {
    visit("levels", spec.levels);
    visit("repeats", spec.repeats);
    visit("shuffled", spec.shuffled);
}

template <class Visit> void keysOf(psychophysics::DescendingSpec& spec, Visit&& visit) {
    visit("levels", spec.levels);
    visit("repeats", spec.repeats);
    visit("passes", spec.passes);
}

template <class Visit> void keysOf(psychophysics::QuestSpec& spec, Visit&& visit) {
    visit("prior_mean", spec.priorMean);
    visit("prior_sd", spec.priorSd);
    visit("target", spec.target);
    visit("slope", spec.slope);
    visit("lapse", spec.lapse);
    visit("guess", spec.guess);
    visit("grain", spec.grain);
    visit("range", spec.range);
    visit("method", spec.method);
    visit("minimum", spec.minimum);
    visit("maximum", spec.maximum);
    visit("stop", spec.stop);
}

template <class Visit> void keysOf(psychophysics::QuestPlusSpec& spec, Visit&& visit) {
    visit("function", spec.function);
    visit("stimuli", spec.stimuli);
    visit("parameters", spec.parameters);
    visit("outcomes", spec.outcomes);
    visit("repeat_limit", spec.repeatLimit);
    visit("catch_every", spec.catchEvery);
    visit("stop", spec.stop);
    visit("seed", spec.seed);
    visit("table", spec.table);
}

template <class Visit> void keysOf(psychophysics::Rank3Spec& spec, Visit&& visit) {
    visit("differences", spec.differences);
    visit("log10_sigma", spec.log10Sigma);
    visit("lapse_rates", spec.lapse);
    visit("allow_ties", spec.allowTies);
    visit("tie_thresholds", spec.tieThresholds);
    visit("stop", spec.stop);
    visit("repeat_limit", spec.repeatLimit);
}

} // namespace chiron::catalogue
