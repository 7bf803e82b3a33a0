// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/object_handling/simulation/loose_body.h"

#include "core/units.h"
#include "simulation/attributes/mass.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

using core::Vec3;

namespace {

constexpr double kT = core::kTickSeconds;

/// Depth x at which the bed's law pushes with `force_N`: F(x) = f, for F = k x and for (k/b)(e^{bx} - 1).
double depthFor(const ElasticLaw& law, double force_N) noexcept {
    const double linear = force_N / law.stiffness_N_per_m;
    return law.stiffening_per_m > 0.0 ? std::log1p(law.stiffening_per_m * linear) / law.stiffening_per_m
                                      : linear;
}

} // namespace

void LooseBody::lieDown(const core::Vec2& place_m, double height_m, double radius_m, double mass_kg,
                        const ObjectContact& bed) noexcept {
    m_radius_m = radius_m;
    m_mass_kg = mass_kg;
    m_restDepth_m = m_depth_m = depthFor(bed.elastic(), mass_kg * core::kStandardGravity);
    p_W = Vec3(place_m.x(), place_m.y(), height_m + radius_m - m_restDepth_m);
    v_W.setZero();
    q_W = core::Quat::Identity();
    m_state.reset();
    m_onBed = ObjectContactResponse();
    m_onBed.energy_J = bed.elastic().energy(m_restDepth_m);
    lieStill();
}

const ObjectContactResponse& LooseBody::pressBed(const ObjectContact& bed,
                                                 const ContactPlace& place) noexcept {
    m_depth_m = place.depth_m;
    m_onBed = bed.respond(place, kT, m_state);
    return m_onBed;
}

void LooseBody::lieStill() noexcept {
    m_restHeight_m = p_W.z();
    m_restEnergy_J = m_onBed.energy_J + Mass::energy(m_mass_kg, p_W.z());
}

double LooseBody::rolling_Ns_per_m() const noexcept {
    return kRolling_Ns_per_m * std::min(1.0, m_onBed.normalForce_N / (m_mass_kg * core::kStandardGravity));
}

Vec3 LooseBody::heldForce() const noexcept {
    Vec3 force = m_onBed.force + Mass::weight(m_mass_kg);
    const double drag = rolling_Ns_per_m();
    force.x() -= drag * v_W.x();
    force.y() -= drag * v_W.y();
    return force;
}

void LooseBody::moveFreely(const Vec3& load) noexcept {
    v_W += (kT / m_mass_kg) * (load + m_onBed.force + Mass::weight(m_mass_kg));
    const double slowed = 1.0 / (1.0 + kT * rolling_Ns_per_m() / m_mass_kg);
    v_W.x() *= slowed;
    v_W.y() *= slowed;
    p_W += kT * v_W;
    if (m_onBed.inContact)
        roll(kT * v_W);
}

void LooseBody::roll(const Vec3& step_m) noexcept {
    const double way2 = step_m.x() * step_m.x() + step_m.y() * step_m.y();
    if (!(way2 > 1e-18)) // less than a nanometre per tick is invisible
        return;
    const double way = std::sqrt(way2);
    const double half = 0.5 * way / m_radius_m;
    const double s = std::sin(half) / way;
    q_W = (core::Quat(std::cos(half), -step_m.y() * s, step_m.x() * s, 0.0) * q_W).normalized();
}

double LooseBody::storedEnergy_J() const noexcept {
    return std::max(0.0, m_onBed.energy_J + Mass::energy(m_mass_kg, p_W.z()) - m_restEnergy_J);
}

} // namespace chiron::simulation
