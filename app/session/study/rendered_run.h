// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/observers/observer_spec.h"
#include "psychophysics/study/run_estimate.h"
#include "session/study/study_progress.h"
#include "simulation/comparison/comparison_parameters.h"

#include <limits>
#include <string>
#include <vector>

namespace chiron::session {

/// A run of one condition by one simulated participant through scene, loop, supervisor and simulated device,
/// without storing anything. Used for tables over many seeds, and for planning with the noise of the
/// rendering.
struct RenderedRunRequest {
    psychophysics::StudyDesign design;
    std::string condition;
    psychophysics::ObserverSpec observer;
    std::uint64_t seed = 1;
    simulation::ComparisonControl control = simulation::ComparisonControl::none;
    int trialsAtMost = 0; ///< 0: as specified by the procedure
};

struct RenderedRun {
    std::vector<database::StudyTrial> trials; ///< every presentation
    psychophysics::RunEstimate estimate;
    std::uint64_t ticks = 0;
    bool completed = false;
    /// The first procedure's own estimate, in its scale.
    double threshold = std::numeric_limits<double>::quiet_NaN();
    std::string procedures; ///< StudyProgress::procedureIds()
};

/// Runs the request.
/// Errors: badInput.
core::Result<RenderedRun> runRendered(const RenderedRunRequest& request);

/// The scored trials in the form that the analysis needs.
std::vector<psychophysics::ScoredTrial> scoredTrials(const psychophysics::Condition& condition,
                                                     const std::vector<database::StudyTrial>& trials);

/// The noise contributed by rendering and hand: a noiseless participant explores `trials` presentations (all
/// arrangements in turn) of one candidate. Values are log10 of estimate over true value, by multiple 0, 1, 2.
struct RenderingNoise {
    double mean[3]{};      ///< log10
    double sd[3]{};        ///< log10
    double pooledSd = 0.0; ///< within multiples: σ_render
    int explored = 0;      ///< places that gave an estimate
    int missed = 0;
    double seconds = 0.0; ///< simulated time per trial
};
core::Result<RenderingNoise> renderingNoise(const psychophysics::StudyDesign& design,
                                            const std::string& condition, int candidate, int trials,
                                            std::uint64_t seed);

} // namespace chiron::session
