// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "simulation/attributes/bristle_friction.h"
#include "simulation/attributes/damping_budget.h"
#include "simulation/attributes/deformation.h"
#include "simulation/attributes/object_attributes.h"
#include "simulation/attributes/roughness.h"

namespace chiron::simulation {

/// Depth below the rest surface down to which a contact has been checked, on planes, balls and meshes
/// (models.md §2.2; test_object_contact, test_mesh_contact). A scene flags deeper samples as
/// core::contact_bits say.
inline constexpr double kCheckedContactDepth_m = 0.006;

/// Where a tool is relative to the rest surface of an object, as computed from the object's geometry: sphere,
/// plane or mesh. Axes are those of W. If the object moves, positions and velocities are relative to it (p_WT
/// − p_WO), so that everything fixed to the object moves with it.
struct ContactPlace {
    double depth_m = 0.0; ///< d, signed: negative outside, needed down to −reach_m() of the contact
    core::Vec3 normal = core::Vec3::UnitZ(); ///< n, outward, unit
    /// ∇d; −n for a true distance. A mesh's blended normal: −n too, but then not conservative.
    core::Vec3 depthGradient = -core::Vec3::UnitZ();
    core::Vec3 foot = core::Vec3::Zero(); ///< C, the surface point under the tool: where roughness is read
    /// How far C moves per metre of the tool's sideways motion: 1 on a plane (and a mesh's facet), R/(R − d)
    /// on a sphere.
    double footScale = 1.0;
    /// Share of the micro-height that counts here, and how it changes along the tool's way, 1/m: 1 and 0, but
    /// where the roughness of an object fades out.
    double roughShare = 1.0;
    core::Vec3 roughShareGradient = core::Vec3::Zero();
    core::Vec3 position = core::Vec3::Zero(); ///< of the tool, for friction
    core::Vec3 velocity = core::Vec3::Zero(); ///< of the tool
    /// The part of the tool's damping budget that this contact may use.
    double mostDamping_Ns_per_m = kUnboundedDamping;
};

/// State of the contact between one tool and one object: its bristle and its dent.
struct ObjectContactState {
    BristleFriction bristle;
    Deformation dent;
    void reset() noexcept {
        bristle.release();
        dent.reset();
    }
};

/// Response of the object: forces on the tool, in W.
struct ObjectContactResponse {
    core::Vec3 force = core::Vec3::Zero();    ///< N, the whole force
    core::Vec3 friction = core::Vec3::Zero(); ///< the part due to the bristle, at most μ normalForce_N
    core::Vec3 viscous = core::Vec3::Zero();  ///< the part due to viscosity, across the normal
    core::Vec3 normal = core::Vec3::UnitZ();  ///< m, outward, roughness included
    double depth_m = 0.0;                     ///< d' = d + h, 0 out of contact
    double normalForce_N = 0.0;               ///< ≥ 0
    /// Energy stored in the springs, also while the surface is still recovering.
    double energy_J = 0.0;
    double stiffness_N_per_m = 0.0; ///< along m; 0 out of contact
    /// The part of the tool's budget that damping and viscosity use.
    double damping_Ns_per_m = 0.0;
    /// How deep the surface lies below its rest position (for drawing).
    double surface_m = 0.0;
    bool inContact = false;
};

/// Scales a contact whose tissue exerts only the share `factor` of its law's force (contact_yield.h).
inline void scale(ObjectContactResponse& response, double factor) noexcept {
    if (factor == 1.0) // keeps every bit
        return;
    response.force *= factor;
    response.friction *= factor;
    response.viscous *= factor;
    response.normalForce_N *= factor;
    response.energy_J *= factor;
    response.stiffness_N_per_m *= factor;
    response.damping_Ns_per_m *= factor;
}

/// Combines the attributes of an object on a given surface, one law for each attribute.
///
/// Elasticity, deformation, roughness:
///   d' = d + h(C),  m = (−∇d − s(I − nnᵀ)∇h)/‖·‖,  (F, U) = Deformation(d')
///
/// Damping and viscosity, which never pull:
///   f_n = max(0, F ‖−∇d − s(I − nnᵀ)∇h‖ − (c + b) w v·m),  w = min(1, d'/0.5 mm)
///
/// All together:
///   f = f_n m − b w (v − (v·m) m) + friction(μ, σ₀, f_n)
///
/// c and b together never exceed the contact's damping budget; where they would, both shrink by the same
/// factor. With elasticity and roughness alone the contact is conservative: f = −∇U exactly, where ∇d is the
/// gradient of a distance and s is C's own (sphere, plane). The other laws only take energy. The weight is
/// not included, because it acts while the object is lifted (attributes/mass.h). Immutable after construction
/// (which allocates nothing); the caller keeps all state, one ObjectContactState per tool. Source: P2 "Object
/// Orientated Modeling"; models.md §0, §2.2.
/// Thread: haptic.
class ObjectContact {
public:
    ObjectContact() noexcept : ObjectContact(ObjectAttributes{}) {}
    explicit ObjectContact(const ObjectAttributes& attributes) noexcept;

    /// Advances by one tick of `dt_s`. Call it in every tick, also outside contact (with the signed depth, or
    /// any negative depth when far away), so that bristle and dent end as they should.
    ObjectContactResponse respond(const ContactPlace& place, double dt_s,
                                  ObjectContactState& state) const noexcept;

    /// A contact may begin this far above the rest surface.
    double reach_m() const noexcept { return m_roughness.bound_m(); }
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
