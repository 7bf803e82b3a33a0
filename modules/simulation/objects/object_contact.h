// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "simulation/attributes/bristle_friction.h"
#include "simulation/attributes/damping_budget.h"
#include "simulation/attributes/deformation.h"
#include "simulation/attributes/object_attributes.h"
#include "simulation/attributes/roughness.h"

namespace chiron::simulation {

/// Where a tool is against the rest surface of an object, as its geometry says: sphere, plane, mesh. Axes of W; places and
/// velocities relative to the object where it moves (p_WT − p_WO), so that what is fixed to it goes along.
struct ContactPlace {
    double depth_m = 0.0;                    ///< d, signed: negative outside, needed down to −reach_m() of the contact
    core::Vec3 normal = core::Vec3::UnitZ(); ///< n, outward, unit
    core::Vec3 depthGradient = -core::Vec3::UnitZ(); ///< ∇d; −n for a true distance. A mesh's blended normal: −n too, not conservative
    core::Vec3 foot = core::Vec3::Zero();    ///< C, the surface point under the tool: where roughness is read
    /// How far C moves for a metre that the tool moves sideways: 1 on a plane (and a mesh's facet), R/(R − d) on a sphere.
    double footScale = 1.0;
    core::Vec3 position = core::Vec3::Zero(); ///< of the tool, for friction
    core::Vec3 velocity = core::Vec3::Zero(); ///< of the tool
    double mostDamping_Ns_per_m = kUnboundedDamping; ///< what of the tool's budget this contact may use
};

/// What one tool has done to one object so far: its bristle and its dent.
struct ObjectContactState {
    BristleFriction bristle;
    Deformation dent;
    void reset() noexcept {
        bristle.release();
        dent.reset();
    }
};

/// What the object answers, on the tool, W.
struct ObjectContactResponse {
    core::Vec3 force = core::Vec3::Zero();    ///< N: all of it
    core::Vec3 friction = core::Vec3::Zero(); ///< the bristle's share, at most μ normalForce_N
    core::Vec3 viscous = core::Vec3::Zero();  ///< the share of viscosity across the normal
    core::Vec3 normal = core::Vec3::UnitZ();  ///< m, outward, roughness included
    double depth_m = 0.0;                     ///< d' = d + h, 0 out of contact
    double normalForce_N = 0.0;               ///< ≥ 0
    double energy_J = 0.0;                    ///< stored in the springs, also while the surface still recovers
    double stiffness_N_per_m = 0.0;           ///< along m; 0 out of contact
    double damping_Ns_per_m = 0.0;            ///< what damping and viscosity use of the tool's budget
    double surface_m = 0.0;                   ///< how deep the surface lies below its rest place (to draw it)
    bool inContact = false;
};

/// A contact whose tissue holds back only `factor` of what its law answers (contact_yield.h).
inline void scale(ObjectContactResponse& response, double factor) noexcept {
    if (factor == 1.0) // to the same bits
        return;
    response.force *= factor;
    response.friction *= factor;
    response.viscous *= factor;
    response.normalForce_N *= factor;
    response.energy_J *= factor;
    response.stiffness_N_per_m *= factor;
    response.damping_Ns_per_m *= factor;
}

/// An object's attributes on a given surface, one law each, combined:
///   d' = d + h(C),  m = (−∇d − s(I − nnᵀ)∇h)/‖·‖,  (F, U) = Deformation(d')            elasticity, deformation, roughness
///   f_n = max(0, F ‖−∇d − s(I − nnᵀ)∇h‖ − (c + b) w v·m),  w = min(1, d'/0.5 mm)       damping, viscosity: never pulls
///   f = f_n m − b w (v − (v·m) m) + friction(μ, σ₀, f_n)
/// c and b together are never more than the place's damping budget: both shrink alike where they are.
/// With elasticity and roughness alone f = −∇U exactly where ∇d is a distance's and s is C's own (sphere, plane): conservative.
/// The rest only takes energy. The weight is not here: it acts while the object is lifted (attributes/mass.h).
/// Immutable after construction (which allocates nothing); all state is the caller's, one a tool. Thread: haptic.
/// Source: P2 "Object Orientated Modeling"; models.md §0, §2.2.
class ObjectContact {
public:
    ObjectContact() noexcept : ObjectContact(ObjectAttributes{}) {}
    explicit ObjectContact(const ObjectAttributes& attributes) noexcept;

    /// One tick of `dt_s`. Call it every tick, outside too (with the signed depth, or any negative one far away): bristle
    /// and dent then end as they should.
    ObjectContactResponse respond(const ContactPlace& place, double dt_s, ObjectContactState& state) const noexcept;

    double reach_m() const noexcept { return m_roughness.bound_m(); } ///< so far above the rest surface it may begin
    const ElasticLaw& elastic() const noexcept { return m_surface.elastic; }
    const Deformation::Parameters& deformation() const noexcept { return m_surface; }
    const Roughness& roughness() const noexcept { return m_roughness; }
    double friction() const noexcept { return m_friction; }
    double mass_kg() const noexcept { return m_mass_kg; }

private:
    Deformation::Parameters m_surface;
    Roughness m_roughness;
    double m_friction = 0.0;
    double m_bristleStiffness_N_per_m = 1000.0;
    double m_viscosity_Ns_per_m = 0.0;
    double m_damping_Ns_per_m = 0.0;
    double m_mass_kg = 0.0;
};

} // namespace chiron::simulation
