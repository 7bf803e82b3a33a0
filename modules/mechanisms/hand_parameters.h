// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::mechanisms {

/// Parameters of one arm and its grip on the tool: mass, damping and stiffness against the desired motion, a
/// stiff damped grip, and physiological tremor; and the same for the wrist that turns the tool. Values of the
/// arm: assumptions of models.md §4. Values of the wrist: assumptions, of the order that a hand with the tool
/// it holds and a lightly tensed wrist have (0.004 kg·m², 2 N·m/rad). The wrist's damping is a third of
/// critical, like the arm's; its grip is the arm's grip at a lever of 50 mm.
struct HandParameters {
    double mass_kg = 0.3;
    double damping_Ns_per_m = 6.0;
    double stiffness_N_per_m = 300.0;
    double gripStiffness_N_per_m = 2000.0;
    double gripDamping_Ns_per_m = 10.0;
    double tremorRms_m = 0.1e-3;    ///< per axis, for the free hand; 8–12 Hz
    double reactionDelay_s = 0.180; ///< 0..0.5; acts only on the intention (motion, buttons)

    double wristInertia_kgm2 = 0.004;
    double wristDamping_Nms_per_rad = 0.06;
    double wristStiffness_Nm_per_rad = 2.0;
    double gripAngularStiffness_Nm_per_rad = 5.0;
    double gripAngularDamping_Nms_per_rad = 0.025;
    double wristTremorRms_rad = 0.5e-3; ///< per axis, for the free hand; the arm's tremor at a lever of 0.2 m

    static constexpr HandParameters light() noexcept {
        return {.mass_kg = 0.1,
                .damping_Ns_per_m = 2.0,
                .stiffness_N_per_m = 100.0,
                .wristInertia_kgm2 = 0.002,
                .wristDamping_Nms_per_rad = 0.03,
                .wristStiffness_Nm_per_rad = 0.8};
    }
    static constexpr HandParameters firm() noexcept {
        return {.mass_kg = 1.0,
                .damping_Ns_per_m = 20.0,
                .stiffness_N_per_m = 800.0,
                .wristInertia_kgm2 = 0.008,
                .wristDamping_Nms_per_rad = 0.15,
                .wristStiffness_Nm_per_rad = 5.0};
    }
};

} // namespace chiron::mechanisms
