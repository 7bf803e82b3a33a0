// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/objects/object_contact.h"

#include "simulation/attributes/contact_damping.h"
#include "simulation/attributes/viscosity.h"

#include <cmath>

namespace chiron::simulation {

ObjectContactResponse ObjectContact::respond(const ContactPlace& place, double dt_s,
                                             ObjectContactState& state) const noexcept {
    ObjectContactResponse out;
    double depth = place.depth_m;
    core::Vec3 outward = -place.depthGradient;
    if (!m_roughness.smooth() && depth > -reach_m()) {
        const RoughnessSample micro = m_roughness.sample(place.foot);
        depth += place.roughShare * micro.height_m;
        outward -= place.roughShare * place.footScale *
                       (micro.gradient - place.normal * place.normal.dot(micro.gradient)) +
                   micro.height_m * place.roughShareGradient;
    }
    const double slant = outward.norm();
    out.normal = slant > 0.0 ? core::Vec3(outward / slant) : place.normal;

    const DeformationResponse pressed = state.dent.press(m_surface, depth, dt_s);
    out.energy_J = pressed.energy_J;
    out.surface_m = pressed.surface_m;
    if (!(depth > 0.0)) {
        state.bristle.release();
        return out;
    }
    out.inContact = true;
    out.depth_m = depth;
    out.stiffness_N_per_m = pressed.stiffness_N_per_m;
    const double leaving = place.velocity.dot(out.normal);
    if (pressed.force_N > 0.0) { // a surface that has not recovered yet neither pushes nor rubs
        const double both = m_damping_Ns_per_m + m_viscosity_Ns_per_m;
        const double fits = DampingBudget::share(both, place.mostDamping_Ns_per_m);
        out.normalForce_N = ContactDamping::normalForce(pressed.force_N * slant, fits * both, depth, leaving);
        out.viscous =
            Viscosity::force(fits * m_viscosity_Ns_per_m, depth, place.velocity - leaving * out.normal);
        out.damping_Ns_per_m = fits * both * Viscosity::weight(depth);
    }
    if (m_friction > 0.0)
        out.friction = state.bristle.update(place.position, out.normal, out.normalForce_N, m_friction,
                                            m_bristleStiffness_N_per_m);
    out.force = out.normalForce_N * out.normal + out.viscous + out.friction;
    return out;
}

} // namespace chiron::simulation
