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
    acquired, ///< found anew in the whole mesh: contact began, or the tool came out of nowhere
    tracked,  ///< along the blended normals, from the last place
    followed, ///< the normals cross here (deeper than the shape is round, or at a sharp edge): the place went along with the tool
};

/// Where a tool is against a mesh.
struct MeshFoot {
    MeshTrack track = MeshTrack::apart;
    MeshPlace place;
    core::Vec3 point = core::Vec3::Zero();   ///< x, on the surface; p while apart
    core::Vec3 normal = core::Vec3::UnitZ(); ///< n, outward, unit, of the blended field at x
    double depth_m = 0.0; ///< (x − p)·n + r, signed; while apart −clearance
    core::Vec3 surfaceMotion = core::Vec3::Zero(); ///< how far x's place moved since the last tick (a moving mesh), m
    bool within() const noexcept { return track != MeshTrack::apart; }
};

/// The closest-surface tracking of one spherical tool tip on one mesh, once a tick:
/// - In contact the place under the tool is found from the last one by projectAlongNormals(): a continuous function of the
///   tool's place while the tool is nearer to the sheet than the sheet is round; the cost does not depend on the mesh's size.
/// - It never moves faster than kFollow times the tool, so a still tool has a still place, and direction and force change by
///   a bounded amount with every 0.01 mm. Where the field folds it goes along with the tool's motion across the line between them.
///   So contact stays on the sheet that was entered, however thin the part and however deep the press, until (x − p)·n + r < 0.
/// - Out of contact the tree is asked only if the tool may have come near: after an answer D nothing is touched within D.
///   A way that crossed the surface between two ticks enters where it first went in; a tool that comes out of nowhere
///   (first tick, a jump beyond kTeleport_m) is given the nearest place.
/// Surface: TriangleMesh, MovedMesh or alike. One object a tool and mesh. Bounded, no allocation. Thread: haptic.
/// Source: P2 "Deformation"; models.md §2.2 force continuum; speed.md "What was learnt".
class MeshTracker {
public:
    static constexpr double kTeleport_m = 0.020; ///< in one tick; models.md §5: a larger jump is no motion
    static constexpr double kFollow = 8.0;       ///< assumption: reached at 7/8 of the radius of a round part
    /// A fast tool's place runs at most kFollowFast times as far and kCatchUp_m more: at 500 N/m a force then changes by no more than
    /// the stiffness times the way and some 0.03 N in a tick, where eight times 0.3 mm would be 1 N.
    static constexpr double kFollowFast = 2.0;
    static constexpr double kCatchUp_m = 5e-5;
    static constexpr double kStill_m = 1e-9;     ///< a place may settle by this much a tick

    /// `p`: the tip's centre in the mesh's frame, m; `radius_m` ≥ 0; `reach_m` ≥ 0: so far above the surface the foot is wanted
    /// already (roughness may begin there).
    template <class Surface> MeshFoot update(const Surface& surface, const core::Vec3& p, double radius_m, double reach_m = 0.0) noexcept {
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

    /// Forgets place and clearance, as when the mesh is swapped.
    void reset() noexcept { *this = MeshTracker(); }
    const MeshFoot& foot() const noexcept { return m_foot; }

private:
    template <class Surface> MeshFoot footAt(const Surface& surface, const core::Vec3& p, const MeshPlace& place, double radius_m, MeshTrack track) const noexcept {
        MeshFoot foot;
        foot.track = track;
        foot.place = place;
        foot.point = pointAt(surface, place);
        foot.normal = normalAt(surface, place);
        foot.depth_m = (foot.point - p).dot(foot.normal) + radius_m;
        return foot;
    }

    template <class Surface> MeshFoot keepUp(const Surface& surface, const core::Vec3& p, double radius_m) noexcept {
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
            foot = footAt(surface, p, glide(surface, m_foot.place, here + sideways(motion, here - p)), radius_m, MeshTrack::followed);
            m_along_m = foot.depth_m - radius_m;
        }
        foot.surfaceMotion = surfaceMotion;
        return foot;
    }

    /// The tool's motion without what only presses or lifts, along the surface. A press straight on moves the place nowhere, however
    /// the normal leans there; else a tool deeper than a rim is round would roll off it.
    core::Vec3 sideways(const core::Vec3& motion, const core::Vec3& toPlace) const noexcept {
        const double length2 = toPlace.squaredNorm();
        const core::Vec3 turned = length2 > 0.0 ? core::Vec3(motion - toPlace * (toPlace.dot(motion) / length2)) : motion;
        return turned - m_foot.normal * m_foot.normal.dot(turned);
    }

    /// Out of contact, or contact has just ended.
    template <class Surface> MeshFoot search(const Surface& surface, const core::Vec3& p, double radius_m, double reach_m, bool jumped) noexcept {
        const double moved = (p - m_askedAt).norm() + m_displacementThen_m + surface.largestDisplacement_m();
        const bool still = surface.largestDisplacement_m() == 0.0 && m_displacementThen_m == 0.0;
        const double clear = m_clearance_m - (still ? (p - m_askedAt).norm() : moved);
        MeshFoot foot;
        foot.point = p;
        foot.depth_m = radius_m - clear;
        if (m_known && !m_foot.within() && clear > radius_m + reach_m)
            return foot;
        // the way since the last tick, if it may have gone through
        const bool through = !jumped && !m_foot.within() && (p - m_tool).norm() > m_clearance_m - (m_tool - m_askedAt).norm();
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

    template <class Surface> MeshFoot acquire(const Surface& surface, const core::Vec3& p, double radius_m, const MeshPlace& at) noexcept {
        MeshPlace place = at;
        m_along_m = (pointAt(surface, at) - p).dot(normalAt(surface, at));
        const double apart = (pointAt(surface, at) - p).norm();
        double along = m_along_m;
        if (projectAlongNormals(surface, p, place, along) && (pointAt(surface, place) - p).norm() <= 2.0 * apart)
            m_along_m = along;
        else
            place = at;
        return footAt(surface, p, place, radius_m, MeshTrack::acquired);
    }

    MeshFoot m_foot;
    core::Vec3 m_tool = core::Vec3::Zero();
    double m_along_m = 0.0; ///< t of projectAlongNormals
    bool m_known = false;   ///< m_tool is of the tick before
    core::Vec3 m_askedAt = core::Vec3::Zero(); ///< where the tree was asked last
    std::uint32_t m_nearest = 0;               ///< and which triangle it named
    double m_clearance_m = -1.0;               ///< what it said; negative: nothing is known to be clear
    double m_displacementThen_m = 0.0;
};

} // namespace chiron::simulation
