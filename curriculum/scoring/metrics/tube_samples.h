// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laparoscopy_cues.h"
#include "scoring/metric.h"
#include "scoring/prepared_trial.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::scoring {

/// What a scene of the elastic tube recorded under this id, one value a sample of tool 0; null where it did not.
inline const std::vector<double>* tubeQuantity(const PreparedTrial& trial, std::string_view id) {
    if (trial.tool == nullptr)
        return nullptr;
    for (const QuantityTrace& quantity : trial.trial->quantities)
        if (quantity.id == id && quantity.values.size() == trial.tool->t_s.size())
            return &quantity.values;
    return nullptr;
}

inline std::optional<double> tubeTruth(const PreparedTrial& trial, std::string_view id) {
    for (const NamedValue& value : trial.trial->truth)
        if (value.id == id)
            return value.value;
    return std::nullopt;
}

/// Why there is nothing to measure, if a trial lacks what the metric reads: a session's value must not silently leave trials
/// out. Null where nothing is lacking.
inline std::optional<Measurement> withoutTube(std::span<const PreparedTrial> trials, std::string_view quantity,
                                              std::string_view truth = {}) {
    if (trials.empty())
        return Measurement::undefined(UndefinedReason::noTrials);
    for (const PreparedTrial& trial : trials) {
        if (tubeQuantity(trial, quantity) == nullptr || tubeQuantity(trial, "step") == nullptr)
            return Measurement::undefined(UndefinedReason::noTubeData);
        if (!truth.empty() && !tubeTruth(trial, truth))
            return Measurement::undefined(UndefinedReason::noSuchTarget);
    }
    return std::nullopt;
}

inline bool isTubeStep(double step, core::LaparoscopyStep wanted) {
    return step == static_cast<double>(wanted);
}

/// Which of a trial's holds are meant, where one was broken and begun again.
enum class TubeHolds {
    all,  ///< a broken one too: an error that ended a hold is an error
    last, ///< the completed one
};

/// The samples of these holds. Paused samples are left out. Empty: nothing was held. Only where withoutTube() has nothing to say.
inline std::vector<std::size_t> tubeHold(const PreparedTrial& trial, TubeHolds meant) {
    const std::vector<double>& step = *tubeQuantity(trial, "step");
    std::vector<std::size_t> hold;
    bool holding = false;
    for (std::size_t i = 0; i < step.size(); ++i) {
        if (trial.tool->paused[i] != 0)
            continue;
        const bool now = isTubeStep(step[i], core::LaparoscopyStep::hold);
        if (now && !holding && meant == TubeHolds::last)
            hold.clear();
        if (now)
            hold.push_back(i);
        holding = now;
    }
    return hold;
}

/// Calls visit(error) with tension − target, N, for each sample of each trial's holds.
template <class Visit> void forEachTensionError(std::span<const PreparedTrial> trials, Visit&& visit) {
    for (const PreparedTrial& trial : trials) {
        const std::vector<double>& tension = *tubeQuantity(trial, "tension_N");
        const double target_N = *tubeTruth(trial, "target_N");
        for (const std::size_t i : tubeHold(trial, TubeHolds::all))
            visit(tension[i] - target_N);
    }
}

inline Measurement neverHeld() {
    return Measurement::undefined(UndefinedReason::tensionNeverHeld);
}

} // namespace chiron::scoring
