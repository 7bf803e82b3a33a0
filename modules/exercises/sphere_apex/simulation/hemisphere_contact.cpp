// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/sphere_apex/simulation/hemisphere_contact.h"

#include "simulation/attributes/contact_damping.h"
#include "simulation/attributes/elasticity.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

/// ‖∇d'‖² = ‖n − ∇h‖² = 1 − 2 n·∇h + ‖∇h‖² is largest towards the apex, where the dimple rises as the ball
/// does. At the distance s from the dimple's centre, on the line through both centres, n's horizontal part at
/// a depth d is (offset − s)/(R − d). It is bounded for depths down to a quarter of the radius.
HemisphereContact::HemisphereContact(const Parameters& parameters) noexcept : m_parameters(parameters) {
    constexpr int kSteps = 64;
    const Dimple& dimple = parameters.dimple;
    const double radius = 0.75 * parameters.surface.radius_m,
                 offset = (dimple.centre_m - parameters.surface.centre_m).norm();
    double square = 1.0;
    for (int i = 0; dimple.depth_m > 0.0 && i <= kSteps; ++i) {
        const double s = dimple.halfWidth_m * i / kSteps;
        const double g = dimple.sample(dimple.centre_m.x() + s, dimple.centre_m.y()).gradient.norm();
        const double lean = std::min(1.0, std::max(0.0, offset - s) / radius);
        square = std::max(square, 1.0 + 2.0 * lean * g + g * g);
    }
    m_steepest = std::sqrt(square * (1.0 + parameters.friction * parameters.friction));
}

ContactResponse HemisphereContact::respond(const core::Vec3& p_WT, const core::Vec3& v_WT,
                                           double mostDamping_Ns_per_m) const noexcept {
    ContactResponse response;
    response.surfacePoint = p_WT;
    const SurfaceDistance surface = m_parameters.surface.distance(p_WT);
    const HeightSample micro = m_parameters.dimple.sample(p_WT.x(), p_WT.y());
    const double depth = micro.height_m - surface.signedDistance_m;

    // −∇d' = n − ∇h, the unscaled outward normal of the surface with its micro-height
    core::Vec3 outward = surface.normal;
    response.normal = surface.normal;
    if (micro.height_m != 0.0) {
        outward.x() -= micro.gradient.x();
        outward.y() -= micro.gradient.y();
        const double slant = outward.norm();
        if (slant > 0.0)
            response.normal = outward / slant;
    }
    if (!(depth > 0.0))
        return response;

    const StiffnessSample k = m_parameters.stiffness.sample(p_WT.x(), p_WT.y());
    const core::Vec3 elastic = Elasticity::force(k.value_N_per_m, k.gradient_N_per_m2, depth, -outward);
    const double elasticNormal = elastic.dot(response.normal);
    const double damping = std::min(m_parameters.damping_Ns_per_m, mostDamping_Ns_per_m);
    response.normalForce_N =
        ContactDamping::normalForce(elasticNormal, damping, depth, v_WT.dot(response.normal));
    response.damping_Ns_per_m = damping * std::min(1.0, depth * (1.0 / ContactDamping::kFullDepth_m));
    response.force = elastic + (response.normalForce_N - elasticNormal) * response.normal;
    response.surfacePoint = p_WT + depth * surface.normal;
    response.depth_m = depth;
    response.energy_J = Elasticity::energy(k.value_N_per_m, depth);
    response.stiffness_N_per_m = k.value_N_per_m;
    if (m_steepest > 1.0)
        response.load_N =
            m_steepest * std::sqrt(2.0 * m_parameters.stiffness.base_N_per_m *
                                   (1.0 + m_parameters.stiffness.variation) * response.energy_J);
    response.inContact = true;
    return response;
}

ContactResponse HemisphereContact::respond(const core::Vec3& p_WT, const core::Vec3& v_WT,
                                           BristleFriction& bristle,
                                           double mostDamping_Ns_per_m) const noexcept {
    ContactResponse response = respond(p_WT, v_WT, mostDamping_Ns_per_m);
    if (!response.inContact || m_parameters.friction == 0.0)
        bristle.release();
    else
        response.force += bristle.update(p_WT, response.normal, response.normalForce_N, m_parameters.friction,
                                         m_parameters.bristleStiffness_N_per_m);
    return response;
}

} // namespace chiron::simulation
