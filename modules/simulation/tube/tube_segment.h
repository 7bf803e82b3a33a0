// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "simulation/attributes/damping_budget.h"
#include "simulation/tube/tube_law.h"

namespace chiron::simulation {

/// The pull of a segment of tube between two points.
struct SegmentPull {
    /// N, W, force on the holder of the first point, towards the second; on the second: the opposite.
    core::Vec3 onFirst = core::Vec3::Zero();
    double tension_N = 0.0; ///< ≥ 0, damping included
    /// Stretch of the whole tube if all of it were strained like this segment; 0 when slack.
    double stretch_m = 0.0;
    double energy_J = 0.0;          ///< elastic
    double stiffness_N_per_m = 0.0; ///< tangent stiffness along the segment
    /// Damping along the segment, as one end feels it while the other is at rest.
    double damping_Ns_per_m = 0.0;
};

/// Stretch at which damping reaches its full value. It fades in from 0, so that the force has no step where a
/// tube becomes taut (models.md §0).
inline constexpr double kTubeDampingFull_m = 0.0005;

/// Computes the pull of a massless straight segment of rest length l out of a tube of rest length L₀, between
/// a and b (m, W), with `rate` = vb − va (m/s) and d = ‖b − a‖, u = (b − a)/d:
///   x = (d − l)·L₀/l,  T = max(0, T(x) + c·min(1, x/0.5 mm)·ẋ),  ẋ = u·rate·L₀/l,  U = (l/L₀)·U(x)
/// It never pushes; force and energy are continuous everywhere; without damping onFirst = −∂U/∂a. Segments of
/// equal tension add up to the whole tube, as springs k/(l/L₀) in series. `restLength_m` = l > 0,
/// `tubeLength_m` = L₀ ≥ l. The damping c L₀/l that an end feels is at most `mostDamping_Ns_per_m`. Pure.
/// Thread: any.
SegmentPull pullOf(const TubeLaw& law, double tubeLength_m, double restLength_m, const core::Vec3& a,
                   const core::Vec3& b, const core::Vec3& rate,
                   double mostDamping_Ns_per_m = kUnboundedDamping) noexcept;

/// The point at share t (0..1) of a segment where it is drawn and gripped: on the chord when taut, beside it
/// when slack.
///   a + t(b − a) + n·√max(0, l² − ‖b − a‖²)·sin(πt)/π,  n ⟂ chord: down, and a little towards +x
/// The bulge stays within min(t, 1 − t)·√(l² − c²), so that neither part is longer than its rest length: a
/// hand that takes hold there feels nothing. A massless tube has no shape of its own when slack; this one is
/// our choice. The point is not below z = 0 unless an end is. Pure.
core::Vec3 tubePlace(const core::Vec3& a, const core::Vec3& b, double restLength_m, double t) noexcept;

} // namespace chiron::simulation
