// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"
#include "simulation/palpation/tissue_contact.h"

#include <algorithm>
#include <cmath>
#include <vector>

/// P3's figure 6: a stroke over a buried tumour with K = [0.80, 0.70, 0.65] N/mm and B = [0.050, 0.045,
/// 0.055] kg/s, a unit of its scene a millimetre. Those are the paper's; it gives neither the tumour's size,
/// depth and stiffness nor the stroke, so these are ours, chosen to stay near the platform's 4 N.
namespace chiron::tests {

struct Figure6 {
    double tumourRadius_m = 0.0020;
    double tumourDepth_m = 0.0022; ///< of its centre
    double tumourStiffness_N_per_m = 3000.0;
    double friction = 0.05;
    double depth_m = 0.0013; ///< of the stroke
    double halfStroke_m = 0.006;
    double speed_m_per_s = 0.004;
};

struct Figure6Sample {
    double t_s = 0.0;
    double y_m = 0.0;
    double force_N = 0.0;       ///< ‖F_ext‖
    double normalForce_N = 0.0; ///< eq. 3
    double lateral_N = 0.0;     ///< along the stroke
    double lean_rad = 0.0;      ///< α, eq. 2
    double shown_rad = 0.0;     ///< α as the platform shows it
    bool saturated = false;
};

inline simulation::TissueContact figure6Tissue(const Figure6& of) {
    simulation::TissueParameters p;
    p.tangentAlong_N_per_m = 800.0;
    p.tangentAcross_N_per_m = 700.0;
    p.stiffness_N_per_m = 650.0;
    p.damping_Ns_per_m = core::Vec3(0.050, 0.045, 0.055);
    p.friction = of.friction;
    p.lumps = simulation::LumpLaw::secondSurface;
    p.secondStiffness_N_per_m = of.tumourStiffness_N_per_m;
    simulation::TissueContact contact(p);
    const simulation::Lump tumour{core::Vec2(0, 0), of.tumourDepth_m, of.tumourRadius_m, 10.0};
    contact.setLumps(std::span(&tumour, 1));
    return contact;
}

/// Down in half a second, along y (the finger's pitch, which may lean 30°), up in half a second; 1 kHz.
inline std::vector<Figure6Sample> figure6(const Figure6& of = {}) {
    const simulation::TissueContact contact = figure6Tissue(of);
    constexpr double kPress_s = 0.5;
    const double stroke_s = 2.0 * of.halfStroke_m / of.speed_m_per_s;
    const auto place = [&](double t_s) {
        const double down = std::clamp(std::min(t_s, 2.0 * kPress_s + stroke_s - t_s) / kPress_s, 0.0, 1.0);
        const double along = std::clamp((t_s - kPress_s) / stroke_s, 0.0, 1.0);
        return core::Vec3(0.0, of.halfStroke_m * (2.0 * along - 1.0), 0.0002 - down * (of.depth_m + 0.0002));
    };
    std::vector<Figure6Sample> samples;
    simulation::TissueTouch touch;
    const int ticks = static_cast<int>(std::lround((2.0 * kPress_s + stroke_s) / core::kTickSeconds));
    for (int i = 0; i <= ticks; ++i) {
        const double t_s = i * core::kTickSeconds;
        core::ToolState tool;
        tool.p_WT = place(t_s);
        tool.v_WT = (place(t_s) - place(t_s - core::kTickSeconds)) / core::kTickSeconds;
        const simulation::TissueResponse r = contact.respond(tool, touch);
        samples.push_back({t_s, tool.p_WT.y(), r.force.norm(), r.normalForce_N, r.force.y(), r.lean_rad,
                           std::hypot(r.display.pitch_rad, r.display.roll_rad), r.leanSaturated});
    }
    return samples;
}

} // namespace chiron::tests
