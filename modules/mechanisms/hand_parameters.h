// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::mechanisms {

/// One arm and its grip on the tool: mass, damping and stiffness against the desired motion, a stiff damped
/// grip, and physiological tremor. Values: assumptions of models.md §4.
struct HandParameters {
    double mass_kg = 0.3;
    double damping_Ns_per_m = 6.0;
    double stiffness_N_per_m = 300.0;
    double gripStiffness_N_per_m = 2000.0;
    double gripDamping_Ns_per_m = 10.0;
    double tremorRms_m = 0.1e-3;    ///< per axis, of the free hand; 8–12 Hz
    double reactionDelay_s = 0.180; ///< 0..0.5; acts on the intention (motion, buttons) only

    static constexpr HandParameters light() noexcept {
        return {.mass_kg = 0.1, .damping_Ns_per_m = 2.0, .stiffness_N_per_m = 100.0};
    }
    static constexpr HandParameters firm() noexcept {
        return {.mass_kg = 1.0, .damping_Ns_per_m = 20.0, .stiffness_N_per_m = 800.0};
    }
};

} // namespace chiron::mechanisms
