// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "simulation/attributes/bristle_friction.h"
#include "simulation/attributes/damping_budget.h"
#include "simulation/attributes/dimple.h"
#include "simulation/attributes/stiffness_field.h"
#include "simulation/geometry/hemisphere_on_plane.h"

#include <cstdint>

namespace chiron::simulation {

/// Response of the surface to a tool at one position; forces are on the tool.
/// Frame: W.
struct ContactResponse {
    core::Vec3 force = core::Vec3::Zero();   ///< N: normal, lateral elastic and friction forces together
    core::Vec3 normal = core::Vec3::UnitZ(); ///< outward, unit, of the touched surface (dimple included)
    /// Where a tool that stays at the surface is drawn; p when not in contact.
    core::Vec3 surfacePoint = core::Vec3::Zero();
    double depth_m = 0.0;           ///< d + h, ≥ 0
    double normalForce_N = 0.0;     ///< ≥ 0
    double energy_J = 0.0;          ///< elastic U = ½ k (d+h)²; the bristle's energy is not counted
    double stiffness_N_per_m = 0.0; ///< k at this position; 0 when not in contact
    double damping_Ns_per_m = 0.0;  ///< the part of the tool's budget that its damping uses
    double load_N = 0.0;            ///< see SceneOutput::load_N; 0: use ‖f‖ itself
    bool inContact = false;
    std::uint8_t bits = 0; ///< core::contact_bits
};

/// The force law of the sphere-apex exercise: HemisphereOnPlane with elasticity, weighted damping,
/// clipped-bristle friction, spatially varying stiffness and a dimple:
///   d' = d + h(x,y);  U = ½ k(x,y) d'²;  f_e = k d' (n − ∇h) − ½ d'² ∇k
///   f_n = max(0, f_e·m − b min(1, d'/0.5 mm) v·m),  m = (n − ∇h)/‖n − ∇h‖
///   f = f_n m + (f_e − (f_e·m) m) + friction(f_n)
/// It never pulls (f·m ≥ 0), is continuous, and equals −∇U without damping and friction. Source:
/// models.md §0, §2.2, §2.3. Immutable after construction; the only state is the caller's BristleFriction
/// (one per tool).
/// Thread: haptic or any.
class HemisphereContact {
public:
    struct Parameters {
        HemisphereOnPlane surface;
        StiffnessField stiffness;
        Dimple dimple;
        double damping_Ns_per_m = 0.0;            ///< b ≥ 0
        double friction = 0.0;                    ///< μ ≥ 0
        double bristleStiffness_N_per_m = 1000.0; ///< σ₀ > 0
    };

    HemisphereContact() = default;
    explicit HemisphereContact(const Parameters& parameters) noexcept;

    /// `p_WT` in m, `v_WT` in m/s. `bristle` is advanced by one tick (and released out of contact or without
    /// friction). `mostDamping_Ns_per_m` is the tool's damping budget.
    ContactResponse respond(const core::Vec3& p_WT, const core::Vec3& v_WT, BristleFriction& bristle,
                            double mostDamping_Ns_per_m = kUnboundedDamping) const noexcept;
    /// Computes the response without friction: a pure function of position and velocity.
    ContactResponse respond(const core::Vec3& p_WT, const core::Vec3& v_WT,
                            double mostDamping_Ns_per_m = kUnboundedDamping) const noexcept;

    const Parameters& parameters() const noexcept { return m_parameters; }

private:
    Parameters m_parameters;
    /// Bounds ‖f‖/√(2 k U) at uniform stiffness, down to a quarter of the radius; it comes from the dimple's
    /// slopes and friction, and is 1 without either.
    double m_steepest = 1.0;
};

/// Scales a contact whose tissue exerts only the share `factor` of its law's force.
inline void scale(ContactResponse& response, double factor) noexcept {
    if (factor == 1.0) // keeps every bit
        return;
    response.force *= factor;
    response.normalForce_N *= factor;
    response.energy_J *= factor;
    response.load_N *= factor;
    response.stiffness_N_per_m *= factor;
    response.damping_Ns_per_m *= factor;
}

} // namespace chiron::simulation
