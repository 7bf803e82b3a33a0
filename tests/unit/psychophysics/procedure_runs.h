// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "psychophysics/procedures/procedure_spec.h"

#include <algorithm>

namespace chiron::tests {

using namespace psychophysics;

inline std::vector<double> even(double from, double to, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
        values.push_back(from + (to - from) * i / std::max(count - 1, 1));
    return values;
}

/// A small 2AFC grid of 30 trials.
inline QuestPlusSpec weibull(int stimuli = 21) {
    QuestPlusSpec spec;
    spec.stimuli = {{"intensity", even(-2.0, 0.0, stimuli)}};
    spec.parameters = {{"threshold", even(-1.8, -0.2, 17), {}, false},
                       {"slope", {2.0, 3.5, 5.0}, {}, false},
                       {"lower_asymptote", {0.5}, {}, false},
                       {"lapse_rate", {0.0, 0.02, 0.05}, {}, false}};
    spec.stop = {.trials = 30};
    return spec;
}

/// An answer drawn: mostly right.
inline int outcome(const Procedure& procedure, core::Random& random) {
    return procedure.outcomes() == 2 ? (random.uniform() < 0.75 ? 1 : 0)
                                     : static_cast<int>(random.below(6)) * (random.uniform() < 0.4 ? 1 : 0);
}

} // namespace chiron::tests
