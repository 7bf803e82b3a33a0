// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/mesh/mesh_query.h"
#include "simulation/geometry/mesh/mesh_walk.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace chiron::simulation {

/// How the place under the tool was found.
enum class MeshTrack : std::uint8_t {
    apart,    ///< nothing within reach
    acquired, ///< searched anew in the whole mesh: contact began, or the tool jumped
    tracked,  ///< found along the blended normals, from the last place
    /// The normals cross here (deeper than the shape is round, or at a sharp edge); the place moved along
    /// with the tool.
    followed,
};

/// Where a tool is relative to a mesh.
struct MeshFoot {
    MeshTrack track = MeshTrack::apart;
    MeshPlace place;
    core::Vec3 point = core::Vec3::Zero();   ///< x, on the surface; p while apart
    core::Vec3 normal = core::Vec3::UnitZ(); ///< n, outward, unit, of the blended field at x
    double depth_m = 0.0;                    ///< (x − p)·n + r, signed; −clearance while apart
    /// How far x's place has moved since the last tick (on a moving mesh), m.
    core::Vec3 surfaceMotion = core::Vec3::Zero();
    bool within() const noexcept { return track != MeshTrack::apart; }
};

/// Tracks the closest place (MeshPlace) of one spherical tool tip on one mesh, once per tick.
/// - In contact, projectAlongNormals() finds the place under the tool from the last one. The place is a
///   continuous function of the tool's position as long as the tool is nearer to the sheet than the sheet's
///   radius of curvature; the cost does not depend on the size of the mesh.
/// - The place never moves faster than kFollow times the tool. A still tool therefore has a still place, and
///   direction and force change by a bounded amount with every 0.01 mm. Where the field folds, the place
///   moves along with the part of the tool's motion that is perpendicular to the line between them. Contact
///   thus stays on the sheet that was entered, however thin the part and however deep the press, until
///   (x − p)·n + r < 0.
/// - Out of contact, the tree is searched only if the tool may have come near: after a search that found the
///   distance D, nothing is touched within D. A path that crossed the surface between two ticks enters where
///   it first went in. A tool that appears suddenly (first tick, or a jump beyond kTeleport_m) is given the
///   nearest place.
///
/// The surface is a TriangleMesh, a MovedMesh or a similar type. Use one instance for each pair of tool and
/// mesh. Bounded. Source: P2 "Deformation"; models.md §2.2 force continuum; speed.md "What was learnt".
/// Thread: haptic; allocates nothing.
class MeshTracker {
public:
    static constexpr double kTeleport_m = 0.020; ///< in one tick; models.md §5: a larger step is not a motion
    /// Assumption: this ratio is reached at 7/8 of the radius of a round part.
    static constexpr double kFollow = 8.0;
    /// The place of a fast tool moves at most kFollowFast times as far as the tool, plus kCatchUp_m. At
    /// 500 N/m a force then changes per tick by no more than twice the stiffness times the tool's distance,
    /// plus some 0.03 N; with kFollow, 0.3 mm would change it by 1 N.
    static constexpr double kFollowFast = 2.0;
    static constexpr double kCatchUp_m = 5e-5;
    static constexpr double kStill_m = 1e-9; ///< a place may settle by this much per tick

    /// `p` is the tip's centre in the mesh's frame, m; `radius_m` ≥ 0. `reach_m` ≥ 0 is the height above the
    /// surface from which on the foot is needed (roughness may begin there).
    template <class Surface>
    MeshFoot update(const Surface& surface, const core::Vec3& p, double radius_m,
                    double reach_m = 0.0) noexcept {
        const bool jumped = !m_known || (p - m_tool).squaredNorm() > kTeleport_m * kTeleport_m;
        MeshFoot foot;
        if (m_foot.within() && !jumped)
            foot = keepUp(surface, p, radius_m);
        if (!foot.within() || foot.depth_m <= -reach_m)
            foot = search(surface, p, radius_m, reach_m, jumped);
        m_tool = p;
        m_known = true;
        m_foot = foot;
        return foot;
    }

    /// Forgets place and clearance, for example when the mesh is replaced.
    void reset() noexcept { *this = MeshTracker(); }
    const MeshFoot& foot() const noexcept { return m_foot; }

private:
    template <class Surface>
    MeshFoot footAt(const Surface& surface, const core::Vec3& p, const MeshPlace& place, double radius_m,
                    MeshTrack track) const noexcept {
        MeshFoot foot;
        foot.track = track;
        foot.place = place;
        foot.point = pointAt(surface, place);
        foot.normal = normalAt(surface, place);
        foot.depth_m = (foot.point - p).dot(foot.normal) + radius_m;
        return foot;
    }

    template <class Surface>
    MeshFoot keepUp(const Surface& surface, const core::Vec3& p, double radius_m) noexcept {
        core::Vec3 here = m_foot.point;
        if constexpr (Surface::kMoves)
            here = pointAt(surface, m_foot.place);
        const core::Vec3 surfaceMotion = here - m_foot.point;
        const core::Vec3 motion = p - m_tool - surfaceMotion;
        const double moved = motion.norm();
        const double most = std::min(kFollow * moved, kFollowFast * moved + kCatchUp_m) + kStill_m;
        const double most2 = most * most;
        MeshPlace place = m_foot.place;
        double along = m_along_m;
        MeshFoot foot;
        if (projectAlongNormals(surface, p, place, along)) {
            m_along_m = along;
            foot = footAt(surface, p, place, radius_m, MeshTrack::tracked);
            const core::Vec3 way = foot.point - here;
            const double length2 = way.squaredNorm();
            if (length2 > most2) {
                const core::Vec3 part = here + way * std::sqrt(most2 / length2);
                foot = footAt(surface, p, glide(surface, m_foot.place, part), radius_m, MeshTrack::followed);
            }
        } else {
            foot = footAt(surface, p, glide(surface, m_foot.place, here + sideways(motion, here - p)),
                          radius_m, MeshTrack::followed);
            m_along_m = foot.depth_m - radius_m;
        }
        foot.surfaceMotion = surfaceMotion;
        return foot;
    }

    /// The tool's motion along the surface, without the parts that only press or lift. A straight press does
    /// not move the place, however the normal leans there; otherwise a tool that is deeper than a rim is
    /// round would roll off it.
    core::Vec3 sideways(const core::Vec3& motion, const core::Vec3& toPlace) const noexcept {
        const double length2 = toPlace.squaredNorm();
        const core::Vec3 turned =
            length2 > 0.0 ? core::Vec3(motion - toPlace * (toPlace.dot(motion) / length2)) : motion;
        return turned - m_foot.normal * m_foot.normal.dot(turned);
    }

    /// Used out of contact, or when contact has just ended.
    template <class Surface>
    MeshFoot search(const Surface& surface, const core::Vec3& p, double radius_m, double reach_m,
                    bool jumped) noexcept {
        const double moved = (p - m_askedAt).norm() + m_displacementThen_m + surface.largestDisplacement_m();
        const bool still = surface.largestDisplacement_m() == 0.0 && m_displacementThen_m == 0.0;
        const double clear = m_clearance_m - (still ? (p - m_askedAt).norm() : moved);
        MeshFoot foot;
        foot.point = p;
        foot.depth_m = radius_m - clear;
        if (m_known && !m_foot.within() && clear > radius_m + reach_m)
            return foot;
        // the path since the last tick, if it may have crossed the surface
        const bool through =
            !jumped && !m_foot.within() && (p - m_tool).norm() > m_clearance_m - (m_tool - m_askedAt).norm();
        const NearestOnMesh nearest = nearestOnMesh(surface, p, m_nearest);
        m_nearest = nearest.place.triangle;
        m_askedAt = p;
        m_clearance_m = nearest.signedDistance_m;
        m_displacementThen_m = surface.largestDisplacement_m();
        foot.depth_m = radius_m - nearest.signedDistance_m;
        const std::optional<MeshPlace> entry = through ? firstEntry(surface, m_tool, p) : std::nullopt;
        if (!entry && !(foot.depth_m > -reach_m))
            return foot;
        return acquire(surface, p, radius_m, entry ? *entry : nearest.place);
    }

    template <class Surface>
    MeshFoot acquire(const Surface& surface, const core::Vec3& p, double radius_m,
                     const MeshPlace& at) noexcept {
        MeshPlace place = at;
        m_along_m = (pointAt(surface, at) - p).dot(normalAt(surface, at));
        const double apart = (pointAt(surface, at) - p).norm();
        double along = m_along_m;
        if (projectAlongNormals(surface, p, place, along) &&
            (pointAt(surface, place) - p).norm() <= 2.0 * apart)
            m_along_m = along;
        else
            place = at;
        return footAt(surface, p, place, radius_m, MeshTrack::acquired);
    }

    MeshFoot m_foot;
    core::Vec3 m_tool = core::Vec3::Zero();
    double m_along_m = 0.0;                    ///< t of projectAlongNormals
    bool m_known = false;                      ///< m_tool is the position of the previous tick
    core::Vec3 m_askedAt = core::Vec3::Zero(); ///< where the tree was searched last
    std::uint32_t m_nearest = 0;               ///< the triangle that this search found
    /// The distance that it found; negative: nothing is known to be clear.
    double m_clearance_m = -1.0;
    double m_displacementThen_m = 0.0;
};

} // namespace chiron::simulation
