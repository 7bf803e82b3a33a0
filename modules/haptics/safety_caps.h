// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/device_sample.h"
#include "core/geometry.h"
#include "haptics/safety_tool.h"

namespace chiron::haptics {

/// The factor that brings a wrench to the nearest cap (models.md §5, caps): min over the actuated axes of
/// cap/|effort|, of force cap/max(‖f‖, load) and of torque cap/‖τ‖. Above 1: there is room; infinity for a zero wrench;
/// 0 where the kinematics answers with something not finite. A cap of 0 is not a limit here (the part is
/// removed before). `sample`: the newest good one. `load_N`: simulation::SceneOutput::load_N. Thread: haptic.
double capRatio(const SafetyToolLimits& limits, const core::DeviceSample& sample,
                const core::Wrench& wrench_W, double load_N = 0.0) noexcept;

/// What is felt, in caps, of a force of `x` caps: x up to 1 − w, 1 from 1 + w on, and the parabola that joins them without a corner between:
/// x − (x − 1 + w)²/(4w). A hand that trembles against a stiff wall at the cap feels the corner of a cut force as a buzz at twice its
/// tremor. w: 0 … 0.5; 0 cuts.
constexpr double bentToCap(double x, double knee) noexcept {
    const double over = x - (1.0 - knee);
    return over <= 0.0 ? x : over >= 2.0 * knee ? 1.0 : x - over * over / (4.0 * knee);
}

/// The energy, in U, that a spring holds whose force is bent into the cap: of U = ½ k s², with x = k s/cap, (2/x²) ∫₀ˣ bentToCap.
constexpr double bentEnergy(double x, double knee) noexcept {
    const double from = 1.0 - knee, over = x - from;
    if (over <= 0.0)
        return 1.0;
    if (over < 2.0 * knee)
        return 1.0 - over * over * over / (6.0 * knee * x * x);
    const double end = 1.0 + knee;
    return 2.0 / (x * x) * (0.5 * end * end - 2.0 / 3.0 * knee * knee + (x - end));
}

/// Scales the whole wrench, so that its direction is kept, until every cap holds; true if it had to.
/// With a knee the force bends into the cap, and true means that it was bent.
bool applyCaps(const SafetyToolLimits& limits, const core::DeviceSample& sample,
               core::Wrench& wrench_W, double load_N = 0.0, double knee = 0.0) noexcept;

} // namespace chiron::haptics
