// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/tool_state.h"
#include "simulation/attributes/damping_budget.h"
#include "simulation/palpation/contact_frame.h"
#include "simulation/palpation/lump_law.h"
#include "simulation/palpation/smooth_patch.h"
#include "simulation/palpation/tissue_parameters.h"
#include "simulation/palpation/tissue_surface.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace chiron::simulation {

/// State that one finger keeps from tick to tick; one instance per tool.
struct TissueTouch {
    bool touching = false;
    /// Bristle, along and across the fibres; kept in the contact frame, so that turning the frame creates no
    /// energy.
    core::Vec2 stretch_m = core::Vec2::Zero();
    core::Vec3 previous_W = core::Vec3::Zero();
    /// Nearest point of the previous tick, from which the next search starts.
    core::Vec2 foot_m = core::Vec2::Zero();
    void release() noexcept { *this = TissueTouch{}; }
};

/// Response of the tissue to one finger.
/// Unit: SI.
/// Frame: W.
struct TissueResponse {
    core::Vec3 force = core::Vec3::Zero();        ///< F_ext on the tool
    core::Vec3 surfacePoint = core::Vec3::Zero(); ///< C; the nearest surface point also out of contact
    core::Vec3 normal{0.0, 0.0, 1.0};             ///< S_n, outward, unit
    double depth_m = 0.0;                         ///< d ≥ 0
    double normalForce_N = 0.0;                   ///< eq. 3, with the unlimited α; ≥ 0
    double lean_rad = 0.0;                        ///< α, eq. 2, unlimited
    core::DisplayPose display;                    ///< for the fingertip platform; limited
    bool leanSaturated = false;
    double energy_J = 0.0; ///< U + ½ zᵀK z
    /// Largest stiffness of the contact, for the passivity credit.
    double stiffness_N_per_m = 0.0;
    /// The part of the tool's budget that the contact's damping uses.
    double damping_Ns_per_m = 0.0;
    bool inContact = false;
    /// Deeper than the lump's law has been checked, or nearer to the surface's centre of curvature.
    bool beyondChecked = false;
};

/// How much the lumps stiffen the tissue for faces that press in another direction than a finger, summed over
/// all faces that were added.
struct LumpsAcross {
    double gain = 0.0;          ///< Σ χ
    double slope_per_m = 0.0;   ///< bound of ‖∂gain/∂q‖
    bool beyondChecked = false; ///< a face is nearer to a lump's centre than R/0.75
};

/// P3's rendering (eq. 1–3) on a tissue with lumps: models.md §3. The contact frame has z = S_n, x = the
/// fibre direction projected on the plane, and y = z × x. The contact is defined and continuous at every
/// depth, and conservative where its law is. Beyond the range of the lumps' law the finger sinks no nearer to
/// them. Near the surface's centre of curvature the depth straight down replaces the depth along the normal.
/// Samples in either range are flagged (`beyondChecked`). Immutable except for setLumps().
/// Thread: haptic; allocates nothing.
class TissueContact {
public:
    /// The catalogue checks the ranges; entries beyond the maxima of TissueParameters are ignored.
    explicit TissueContact(const TissueParameters& parameters);

    /// Takes at most kMaxLumps lumps and computes their centres in W.
    void setLumps(std::span<const Lump> lumps) noexcept;
    int lumps() const noexcept { return m_lumpCount; }
    core::Vec3 lumpCentre_W(int lump) const noexcept;

    /// Computes the response to one tool, whose state is `touch`. B shrinks to `mostDamping_Ns_per_m`, the
    /// tool's budget. If the tool's state is not finite, releases `touch` and returns an empty response.
    TissueResponse respond(const core::ToolState& tool, TissueTouch& touch,
                           double mostDamping_Ns_per_m = kUnboundedDamping) const noexcept;

    /// Adds the gain of all lumps for a face of the pad's radius at `face_W` that presses along `across`
    /// (length at most 1): χ as in lump_law.h, with that direction in place of the normal.
    void addLumpsAcross(const core::Vec3& face_W, const core::Vec3& across, LumpsAcross& sum) const noexcept;

    const TissueSurface& surface() const noexcept { return m_surface; }
    /// Stiffness that holds the finger sideways, N/m: the smaller one of along and across the fibres.
    double tangentStiffness_N_per_m() const noexcept {
        return std::min(m_parameters.tangentAlong_N_per_m, m_parameters.tangentAcross_N_per_m);
    }
    /// k; computed from the layers where it is not given.
    double normalStiffness_N_per_m() const noexcept { return m_normalStiffness; }

private:
    struct PlacedLump {
        core::Vec3 centre_W = core::Vec3::Zero();
        double radius_m = 0.0;
        double strength_m4 = 0.0; ///< (8/π) a R³ (m − 1)/(1 + 0.4 (m − 1))
    };
    /// The elastic part of the response, without the bristle. It depends neither on speed nor on history.
    struct Elastic {
        core::Vec3 force = core::Vec3::Zero();
        double energy_J = 0.0;
        double stiffness_N_per_m = 0.0;
    };
    /// Where a finger touches. Except with P3's re-cast ray, `spring_m` is d along the normal.
    struct Meeting {
        SurfaceFoot foot;                          ///< nearest point
        core::Vec3 contact_W = core::Vec3::Zero(); ///< C
        core::Vec3 spring_m = core::Vec3::Zero();  ///< C − p
        ContactFrame frame;
    };
    Meeting meet(const core::ToolState& tool, const SurfaceFoot& foot) const noexcept;
    StiffnessGain gainAt(const SurfaceFoot& foot, const core::Vec3& p_W) const noexcept;
    SunkContact sunk(const SurfaceFoot& foot, const core::Vec3& p_W) const noexcept;
    void turnUpright(Meeting& meeting, const core::Vec3& p_W, Elastic& elastic) const noexcept;
    Elastic pressOn(const Meeting& meeting, const core::Vec3& p_W) const noexcept;
    void addBalls(const core::Vec3& p_W, Elastic& elastic) const noexcept;
    core::Vec3 bristle(const core::Vec3& p_W, const ContactFrame& frame, double normalForce_N,
                       TissueTouch& touch, double& energy_J) const noexcept;
    void show(const core::ToolState& tool, TissueResponse& out) const noexcept;

    TissueParameters m_parameters;
    TissueSurface m_surface;
    double m_normalStiffness = 0.0;
    double m_perDampingDepth = 0.0; ///< 1/m
    double m_largestTangent = 0.0;  ///< N/m, 0 where nothing holds the finger sideways
    ContactFrame m_flatFrame;
    std::size_t m_regionCount = 0;
    std::array<SmoothPatch, TissueParameters::kMaxRegions> m_regions{};
    /// Largest second derivative of each region's gain.
    std::array<double, TissueParameters::kMaxRegions> m_regionBend_per_m2{};
    /// The lumps' law is valid to this depth, λ d ≤ (h − R)/2; infinite without lumps.
    double m_sunkDepth_m;
    /// From here to m_uprightTo_m the law of a curved surface changes over to one without a centre of
    /// curvature.
    double m_uprightFrom_m;
    double m_uprightTo_m; ///< both are infinite where the surface is flat
    int m_lumpCount = 0;
    std::array<PlacedLump, TissueParameters::kMaxLumps> m_lumps{};
};

} // namespace chiron::simulation
