// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/palpation/tissue_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::simulation {

namespace {
constexpr int kMostSteps = 24; ///< three or four are usual
constexpr int kMostHalvings = 20;
constexpr double kSmallStep2_m2 = 1e-16; ///< after a last Newton step of 10 nm the error is below 1e-13 m
constexpr double kRayStep2_m2 = 1e-26;   ///< 0.1 pm
constexpr double kFarthest_m = 0.1;      ///< longest ray
constexpr double kInfinite = std::numeric_limits<double>::infinity();

core::Vec3 upNormal(const core::Vec2& slope) noexcept {
    return core::Vec3(-slope.x(), -slope.y(), 1.0) / std::sqrt(1.0 + slope.squaredNorm());
}

/// ∇²(½‖p − C‖²) with respect to x and y; `above_m` = z_C − z_p.
Eigen::Matrix2d distanceHessian(const SurfaceHeight& at, double above_m) noexcept {
    return Eigen::Matrix2d::Identity() + at.slope * at.slope.transpose() + above_m * at.curvature_per_m;
}

double distance2(const core::Vec3& p_W, const core::Vec2& xy_m, const SurfaceHeight& at) noexcept {
    const double above = at.z_m - p_W.z();
    return (xy_m - p_W.head<2>()).squaredNorm() + above * above;
}

core::Vec2 newtonMove(const core::Vec3& p_W, const core::Vec2& xy_m, const SurfaceHeight& at) noexcept {
    const double above = at.z_m - p_W.z();
    const core::Vec2 gradient = (xy_m - p_W.head<2>()) + above * at.slope;
    Eigen::Matrix2d hessian = distanceHessian(at, above);
    // Beyond a centre of curvature: Gauss–Newton's, which is positive
    if (!(hessian.determinant() > 1e-5) || !(hessian.trace() > 0.0))
        hessian = distanceHessian(at, 0.0);
    return hessian.inverse() * gradient;
}

SurfaceFoot footAt(const core::Vec3& p_W, const core::Vec2& xy_m, const SurfaceHeight& at) noexcept {
    SurfaceFoot foot;
    foot.p_W = {xy_m.x(), xy_m.y(), at.z_m};
    foot.normal = upNormal(at.slope);
    foot.depth_m = (foot.p_W - p_W).dot(foot.normal);
    Eigen::Matrix2d hessian = distanceHessian(at, at.z_m - p_W.z());
    if (!(hessian.determinant() > 1e-5))
        hessian = distanceHessian(at, 0.0);
    Eigen::Matrix<double, 3, 2> onSurface;
    onSurface << 1.0, 0.0, 0.0, 1.0, at.slope.x(), at.slope.y();
    foot.follows = onSurface * hessian.inverse() * onSurface.transpose();
    return foot;
}
} // namespace

TissueSurface::TissueSurface(const SurfaceShape& shape)
    : m_planeHeight_m(shape.planeHeight_m), m_deepestUnique_m(kInfinite), m_highestUnique_m(kInfinite) {
    for (const SurfaceBump& bump : shape.bumps) {
        if (m_count == SurfaceShape::kMaxBumps)
            break;
        m_bumps[m_count++] = SmoothPatch::over(bump.centre_m, bump.radii_m, bump.turn_rad, bump.height_m);
    }
    measureCurvature();
}

SurfaceHeight TissueSurface::heightAt(const core::Vec2& xy_m) const noexcept {
    SurfaceHeight out;
    out.z_m = m_planeHeight_m;
    for (std::size_t i = 0; i < m_count; ++i)
        m_bumps[i].add(xy_m, out.z_m, out.slope, out.curvature_per_m);
    return out;
}

core::Vec3 TissueSurface::pointAt(const core::Vec2& xy_m) const noexcept {
    return {xy_m.x(), xy_m.y(), heightAt(xy_m).z_m};
}

core::Vec3 TissueSurface::normalAt(const core::Vec2& xy_m) const noexcept {
    return upNormal(heightAt(xy_m).slope);
}

SurfaceFoot TissueSurface::curvedFoot(const core::Vec3& p_W, const core::Vec2& guess_m) const noexcept {
    const SurfaceFoot foot = descend(p_W, guess_m);
    const bool unique = foot.depth_m < m_deepestUnique_m && -foot.depth_m < m_highestUnique_m;
    return unique ? foot : farFoot(p_W, foot);
}

/// Used where the foot is not unique, or after a jump. Returns the nearer one of the given foot and the foot
/// that a search from the tool's own x and y finds.
SurfaceFoot TissueSurface::farFoot(const core::Vec3& p_W, const SurfaceFoot& found) const noexcept {
    const SurfaceFoot below = descend(p_W, p_W.head<2>());
    SurfaceFoot foot = std::abs(below.depth_m) + 1e-9 < std::abs(found.depth_m) ? below : found;
    const bool inside = p_W.z() < heightAt(p_W.head<2>()).z_m;
    if (inside != (foot.depth_m > 0.0)) // such a foot lies on the other side of a ridge or a furrow
        foot = below;
    if (!inside)
        foot.depth_m = std::min(foot.depth_m, 0.0);
    return foot;
}

/// Descends to the zero of the gradient of ½‖p − (xy, z(xy))‖², (xy − p_xy) + (z − p_z)·slope; every step
/// goes downhill.
SurfaceFoot TissueSurface::descend(const core::Vec3& p_W, const core::Vec2& from_m) const noexcept {
    core::Vec2 xy = from_m;
    SurfaceHeight at = heightAt(xy);
    double now2 = distance2(p_W, xy, at);
    for (int step = 0; step < kMostSteps; ++step) {
        core::Vec2 move = newtonMove(p_W, xy, at);
        SurfaceHeight next = heightAt(xy - move);
        double next2 = distance2(p_W, xy - move, next);
        for (int halving = 0; next2 > now2 + kSmallStep2_m2 && halving < kMostHalvings; ++halving) {
            move *= 0.5;
            next = heightAt(xy - move);
            next2 = distance2(p_W, xy - move, next);
        }
        xy -= move;
        at = next;
        now2 = next2;
        if (move.squaredNorm() < kSmallStep2_m2)
            break;
    }
    return footAt(p_W, xy, at);
}

bool TissueSurface::meets(const core::Vec3& p_W, const core::Vec3& direction,
                          core::Vec3& hit_W) const noexcept {
    double along_m = 0.0;
    for (int step = 0; step < kMostSteps; ++step) {
        const core::Vec3 p = p_W + along_m * direction;
        const SurfaceHeight at = heightAt(p.head<2>());
        const double approach = direction.z() - at.slope.dot(direction.head<2>()); // d(z_p − z)/d along
        if (std::abs(approach) < 0.05) // the line runs along the surface, without a distinct intersection
            return false;
        const double move_m = (at.z_m - p.z()) / approach;
        along_m += move_m;
        if (!(std::abs(along_m) <= kFarthest_m))
            return false;
        if (move_m * move_m < kRayStep2_m2)
            break;
    }
    hit_W = p_W + along_m * direction;
    return true;
}

double TissueSurface::highest_m() const noexcept {
    double z_m = m_planeHeight_m;
    for (std::size_t i = 0; i < m_count; ++i)
        z_m += std::max(0.0, m_bumps[i].height);
    return z_m;
}

/// Principal curvatures are the eigenvalues of G⁻¹ H/√(1 + s²), G = 1 + s sᵀ; negative ones bend towards the
/// tissue.
void TissueSurface::measureCurvature() noexcept {
    constexpr int kSide = 81;
    double inwards = 0.0, outwards = 0.0;
    for (std::size_t i = 0; i < m_count; ++i) {
        // Half extents of the ellipse along x and y: square roots of the inverse shape's diagonal.
        const core::Vec2 half = m_bumps[i].shape.inverse().diagonal().cwiseSqrt();
        for (int n = 0; n < kSide * kSide; ++n) {
            const core::Vec2 share(2.0 * (n % kSide) / (kSide - 1) - 1.0,
                                   2.0 * (n / kSide) / (kSide - 1) - 1.0);
            const SurfaceHeight at = heightAt(m_bumps[i].centre_m + half.cwiseProduct(share));
            const Eigen::Matrix2d metric = Eigen::Matrix2d::Identity() + at.slope * at.slope.transpose();
            const Eigen::Matrix2d shape =
                metric.inverse() * at.curvature_per_m / std::sqrt(1.0 + at.slope.squaredNorm());
            const double middle = 0.5 * shape.trace();
            const double spread = std::sqrt(std::max(0.0, middle * middle - shape.determinant()));
            inwards = std::max(inwards, spread - middle);
            outwards = std::max(outwards, spread + middle);
        }
    }
    m_deepestUnique_m = inwards > 0.0 ? 0.99 / inwards : kInfinite;
    m_highestUnique_m = outwards > 0.0 ? 0.99 / outwards : kInfinite;
}

} // namespace chiron::simulation
