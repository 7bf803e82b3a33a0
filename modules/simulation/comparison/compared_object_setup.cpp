// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/comparison/compared_object.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

/// How many times √(2kU) the force of rough pads may be, U being the energy of all `places` together: either
/// one pad's alone, whose outward normal −∇d' is longer than 1 by three standard deviations of its slope
/// (waves of one length in all directions have one of rms (2π/λ) √(2/3) along a plane); or all edges at once,
/// between which a tool is pressed, where the roughness has faded out and the forces add up as √places at
/// most.
double steepestOf(const ObjectAttributes& pad, double edge, int places) noexcept {
    const double wavelength_m = std::max(pad.roughnessWavelength_m, Roughness::kShortestWavelength_m);
    const double rough = 3.0 * pad.roughness_m * (2.0 * core::kPi / wavelength_m) * std::sqrt(2.0 / 3.0);
    return std::max(std::hypot(1.0, rough), std::sqrt(static_cast<double>(places)) * std::hypot(1.0, edge));
}

} // namespace

void ComparedObject::set(const ComparisonParameters& p, int place, double value,
                         std::uint64_t seed) noexcept {
    // A tube that is changed in a running trial was let go all the same.
    const bool awayFirst = m_awayFirst && m_leaveBeforeAgain;
    release();
    m_awayFirst = awayFirst;
    m_present = true;
    m_attribute = p.attribute;
    m_foot = core::Vec3(placeX_m(p, place), 0.0, 0.0);
    m_height_m = p.hookHeight_m;
    m_reach_m = p.hookReach_m;
    m_leave_m = p.hookLeave_m;
    m_leaveBeforeAgain = p.leaveBeforeAgain;
    m_radius_m = p.padRadius_m;
    m_edge_m = p.padEdge_m;
    m_slope = p.padSlope;
    const ObjectAttributes& o = p.object;
    switch (p.attribute) {
    case ComparedAttribute::stiffness:
        m_tube.elastic = {value, o.stiffening_per_m};
        m_tube.viscosity_Ns_per_m = o.viscosity_Ns_per_m;
        return;
    case ComparedAttribute::mass:
        m_mass_kg = value;
        m_bed_N_per_m = std::max(1.0, o.stiffness_N_per_m);
        m_bedDamping_Ns_per_m = o.damping_Ns_per_m;
        m_yield = ContactYield(p.yield);
        return;
    case ComparedAttribute::deformation:
    case ComparedAttribute::roughness:
    case ComparedAttribute::friction:
    case ComparedAttribute::viscosity:
        break;
    }
    ObjectAttributes pad; // its id stays short: this runs in the tick, and a long string would allocate
    pad.stiffness_N_per_m = o.stiffness_N_per_m;
    pad.stiffening_per_m = o.stiffening_per_m;
    pad.recoveryTime_s = p.attribute == ComparedAttribute::deformation ? value : o.recoveryTime_s;
    pad.recoveryShare = o.recoveryShare;
    pad.roughness_m = p.attribute == ComparedAttribute::roughness ? value : o.roughness_m;
    pad.roughnessWavelength_m = o.roughnessWavelength_m;
    pad.roughnessSeed = seed;
    pad.friction = p.attribute == ComparedAttribute::friction ? value : o.friction;
    pad.bristleStiffness_N_per_m = o.bristleStiffness_N_per_m;
    pad.viscosity_Ns_per_m = p.attribute == ComparedAttribute::viscosity ? value : o.viscosity_Ns_per_m;
    pad.damping_Ns_per_m = o.damping_Ns_per_m;
    m_pad = ObjectContact(pad);
    m_steepest = pad.roughness_m > 0.0 ? steepestOf(pad, p.padSlope, p.places) : 1.0;
}

} // namespace chiron::simulation
