// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/comparison/compared_object.h"

#include "core/units.h"
#include "simulation/attributes/contact_damping.h"
#include "simulation/tube/tube_segment.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

void ComparedObject::release() noexcept {
    m_held = m_touching = m_lifted = m_pressed = m_awayFirst = false;
    m_state.reset();
}

ComparedResponse ComparedObject::respond(const core::Vec3& p, const core::Vec3& v,
                                         double mostDamping_Ns_per_m, bool mayLift) noexcept {
    ComparedResponse out;
    if (!m_present) {
        out.surfacePoint = p;
        return out;
    }
    out = m_attribute == ComparedAttribute::stiffness ? pull(p, v, mostDamping_Ns_per_m)
          : m_attribute == ComparedAttribute::mass    ? lift(p, v, mostDamping_Ns_per_m, mayLift)
                                                      : press(p, v, mostDamping_Ns_per_m);
    m_touching = out.touching;
    out.held = m_held;
    return out;
}

ComparedResponse ComparedObject::pull(const core::Vec3& p, const core::Vec3& v,
                                      double mostDamping_Ns_per_m) noexcept {
    ComparedResponse out;
    out.surfacePoint = p;
    const bool slack = (p - m_foot).norm() <= m_height_m;
    const double away_m = (p - ring()).norm();
    if (!m_held) {
        m_awayFirst = m_awayFirst && slack;
        m_held = slack && away_m <= m_reach_m && !m_awayFirst;
    } else if (slack && away_m > m_leave_m) {
        m_held = false;
        m_awayFirst = m_leaveBeforeAgain;
    }
    if (!m_held)
        return out;
    const SegmentPull pull = pullOf(m_tube, m_height_m, m_height_m, m_foot, p, v, mostDamping_Ns_per_m);
    out.force = -pull.onFirst;
    out.energy_J = pull.energy_J;
    out.stiffness_N_per_m = pull.stiffness_N_per_m;
    out.damping_Ns_per_m = pull.damping_Ns_per_m;
    out.displacement_m = pull.stretch_m;
    out.touching = pull.stretch_m > 0.0;
    return out;
}

ComparedResponse ComparedObject::lift(const core::Vec3& p, const core::Vec3& v, double mostDamping_Ns_per_m,
                                      bool mayLift) noexcept {
    ComparedResponse out;
    out.surfacePoint = p;
    const double away_m = (p - ring()).norm();
    if (!m_held) {
        m_awayFirst = m_awayFirst && away_m <= m_leave_m;
        if (m_awayFirst || away_m > m_reach_m || !mayLift)
            return out;
        m_held = true;
        m_lifted = m_pressed = false;
        m_yield.reset();
        m_offset = ring() - p;
    }
    const double weight_N = m_mass_kg * core::kStandardGravity;
    const double atRest_m = weight_N / m_bed_N_per_m;
    const double lift_m = p.z() + m_offset.z() - ring().z();
    const double depth_m = std::max(0.0, atRest_m - lift_m);
    const double bed_N = m_bed_N_per_m * depth_m;
    m_lifted = m_lifted || lift_m > kLifted_m;
    m_pressed = m_lifted && (m_pressed || bed_N > weight_N + kPress_N);
    if (m_pressed && lift_m >= 0.0) {
        comeOff();
        return out;
    }
    // Damping fades in from the rest position: there is none at rest and none in the air
    const double below_m = std::max(0.0, -lift_m);
    const double damping = std::min(m_bedDamping_Ns_per_m, mostDamping_Ns_per_m);
    const double support_N = ContactDamping::normalForce(bed_N, damping, below_m, v.z());
    out.damping_Ns_per_m = damping * std::min(1.0, below_m / ContactDamping::kFullDepth_m);
    out.force = core::Vec3(0.0, 0.0, support_N - weight_N);
    out.energy_J = weight_N * lift_m + 0.5 * m_bed_N_per_m * (depth_m * depth_m - atRest_m * atRest_m);
    out.stiffness_N_per_m = depth_m > 0.0 ? m_bed_N_per_m : 0.0;
    out.displacement_m = lift_m;
    out.touching = true;
    yieldTo(out);
    return out;
}

void ComparedObject::comeOff() noexcept {
    m_held = m_lifted = m_pressed = false;
    m_awayFirst = true;
}

/// Lets the bed give way to what presses on it; the weight of what is lifted is no load on it. Once the force
/// has fallen, the object is let go.
void ComparedObject::yieldTo(ComparedResponse& pressed) noexcept {
    const double load_N = m_yield.through() ? pressed.force.norm() : std::max(0.0, pressed.force.z());
    const double holds = m_yield.step(load_N, false, false, core::kTickSeconds);
    pressed.contact = m_yield.bits();
    if (m_yield.gone()) {
        comeOff();
        pressed = {.surfacePoint = pressed.surfacePoint, .contact = pressed.contact};
        return;
    }
    pressed.force *= holds;
    pressed.energy_J *= holds;
    pressed.stiffness_N_per_m *= holds;
    pressed.damping_Ns_per_m *= holds;
}

ComparedObject::Top ComparedObject::topAt(double rho_m) const noexcept {
    const double out_m = std::max(0.0, rho_m - m_radius_m);
    const double round_m = m_edge_m * m_slope; // of the edge, before the cone begins
    if (m_slope > 0.0 && out_m > round_m)
        return {m_slope * (out_m - 0.5 * round_m), m_slope, m_slope / rho_m, 0.0, 0.0};
    Top top{.fall_m = 0.5 * out_m * out_m / m_edge_m, .slope = out_m / m_edge_m};
    if (out_m > 0.0)
        top.turn_per_m = 1.0 / m_edge_m;
    if (m_slope > 0.0) { // a smoothstep
        const double t = out_m / round_m;
        top.rough = 1.0 - t * t * (3.0 - 2.0 * t);
        top.roughSlope_per_m = -6.0 * t * (1.0 - t) / round_m;
    }
    return top;
}

ComparedResponse ComparedObject::press(const core::Vec3& p, const core::Vec3& v,
                                       double mostDamping_Ns_per_m) noexcept {
    ComparedResponse out;
    ContactPlace place;
    const core::Vec3 across(p.x() - m_foot.x(), p.y() - m_foot.y(), 0.0);
    const double rho_m = across.norm();
    const Top top = topAt(rho_m);
    const double top_m = m_foot.z() - top.fall_m;
    place.depth_m = top_m - p.z();
    place.depthGradient = -core::Vec3::UnitZ();
    if (top.slope > 0.0)
        place.depthGradient -= across * (top.slope / rho_m);
    place.roughShare = top.rough;
    if (top.roughSlope_per_m != 0.0)
        place.roughShareGradient = across * (top.roughSlope_per_m / rho_m);
    const bool bounded = m_slope > 0.0;
    place.normal = bounded ? core::Vec3(core::Vec3::UnitZ()) : core::Vec3(-place.depthGradient.normalized());
    place.foot = core::Vec3(p.x(), p.y(), bounded ? m_foot.z() : top_m);
    place.position = p;
    place.velocity = v;
    place.mostDamping_Ns_per_m = mostDamping_Ns_per_m;
    const ObjectContactResponse contact = m_pad.respond(place, core::kTickSeconds, m_state);
    out.force = contact.force;
    out.energy_J = contact.energy_J;
    out.damping_Ns_per_m = contact.damping_Ns_per_m;
    out.stiffness_N_per_m = contact.stiffness_N_per_m;
    if (bounded) // of the smooth surface's second derivative of energy: k ∇d ∇dᵀ + F ∇∇d
        out.stiffness_N_per_m = contact.stiffness_N_per_m * place.depthGradient.squaredNorm() +
                                contact.normalForce_N * top.turn_per_m;
    if (bounded && m_steepest > 1.0) // the slope differs where the energy does not
        out.load_N2 = 2.0 * m_pad.elastic().stiffness_N_per_m * contact.energy_J;
    out.displacement_m = contact.depth_m;
    out.depth_m = place.depth_m;
    out.touching = contact.inContact;
    out.surfacePoint = contact.inContact ? core::Vec3(p.x(), p.y(), top_m) : p;
    return out;
}

} // namespace chiron::simulation
