// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "simulation/palpation/smooth_patch.h"
#include "simulation/palpation/tissue_parameters.h"

#include <Eigen/Core>
#include <array>
#include <cstddef>

namespace chiron::simulation {

/// Height of the surface over (x, y) with its first and second derivatives.
struct SurfaceHeight {
    double z_m = 0.0; ///< W
    core::Vec2 slope = core::Vec2::Zero();
    Eigen::Matrix2d curvature_per_m = Eigen::Matrix2d::Zero();
};

/// The surface point nearest to a tool.
struct SurfaceFoot {
    core::Vec3 p_W = core::Vec3::Zero();
    core::Vec3 normal{0.0, 0.0, 1.0}; ///< outward, unit
    double depth_m = 0.0;             ///< > 0 below the surface
    /// How the foot moves with the tool, ∂p_W/∂p_WT, on the tangent plane: (1 + d·S)⁻¹ with the shape
    /// operator S.
    core::Mat3 follows = core::Mat3::Identity();
};

/// The smooth surface of a tissue (SurfaceShape). The same geometry is felt and drawn. Immutable.
/// Unit: m.
/// Frame: W.
/// Thread: any; allocates nothing after construction.
class TissueSurface {
public:
    explicit TissueSurface(const SurfaceShape& shape);

    bool flat() const noexcept { return m_count == 0; }
    SurfaceHeight heightAt(const core::Vec2& xy_m) const noexcept;
    core::Vec3 pointAt(const core::Vec2& xy_m) const noexcept;  ///< on the surface
    core::Vec3 normalAt(const core::Vec2& xy_m) const noexcept; ///< outward, unit
    /// Finds the surface point nearest to `p_W` by damped Newton steps from a guess (x, y); from the foot of
    /// the previous tick it takes two or three. Down to deepestUnique_m() there is one foot, the same from
    /// every guess; deeper, the foot is continuous while the tool moves on. The sign of the depth is right
    /// everywhere.
    SurfaceFoot nearest(const core::Vec3& p_W, const core::Vec2& guess_m) const noexcept {
        return flat() ? flatFoot(p_W) : curvedFoot(p_W, guess_m);
    }
    /// Down to this depth no point of the tissue has two nearest surface points; infinite where the surface
    /// is flat. It is the smallest radius of curvature towards the tissue, searched on a grid of 81² points
    /// per bump and reduced by 1 %. This criterion is sufficient: the other way to lose uniqueness, two feet
    /// of one point with opposite normals, needs a surface that is not a height over x and y.
    double deepestUnique_m() const noexcept { return m_deepestUnique_m; }
    /// The same bound outwards, above furrows.
    double highestUnique_m() const noexcept { return m_highestUnique_m; }
    /// Finds where the line p_W + s·direction meets the surface nearest to p_W. Returns false if it does not
    /// within ±0.1 m.
    bool meets(const core::Vec3& p_W, const core::Vec3& direction, core::Vec3& hit_W) const noexcept;
    double highest_m() const noexcept; ///< upper bound of z over the whole surface

private:
    SurfaceFoot flatFoot(const core::Vec3& p_W) const noexcept {
        SurfaceFoot foot;
        foot.p_W = {p_W.x(), p_W.y(), m_planeHeight_m};
        foot.depth_m = m_planeHeight_m - p_W.z();
        foot.follows = core::Vec3(1.0, 1.0, 0.0).asDiagonal();
        return foot;
    }
    SurfaceFoot curvedFoot(const core::Vec3& p_W, const core::Vec2& guess_m) const noexcept;
    SurfaceFoot descend(const core::Vec3& p_W, const core::Vec2& from_m) const noexcept;
    SurfaceFoot farFoot(const core::Vec3& p_W, const SurfaceFoot& found) const noexcept;
    void measureCurvature() noexcept;

    double m_planeHeight_m;
    double m_deepestUnique_m;
    double m_highestUnique_m;
    std::size_t m_count = 0;
    std::array<SmoothPatch, SurfaceShape::kMaxBumps> m_bumps{};
};

} // namespace chiron::simulation
