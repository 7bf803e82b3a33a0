// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/elastic_tube/scene/tube_mesh.h"

#include "desktop/scene3d/parts/floor_shade.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

constexpr double kMark_m = 0.0011; // half width of a painted ring
constexpr int kTubeSides = 18;

/// Adds a short sleeve round the tube, centred at this fraction of its length.
void addSleeve(TriangleMesh& mesh, const TubeCurve& curve, double share, double half_m) {
    for (const TubePiece& piece : curve.pieces) {
        for (std::size_t k = 1; k < piece.rings.size(); ++k) {
            const TubeRing& a = piece.rings[k - 1];
            const TubeRing& b = piece.rings[k];
            if (!(a.share <= share && share < b.share))
                continue;
            const double t = (share - a.share) / std::max(1e-9, b.share - a.share);
            const core::Vec3 middle = a.p_W + t * (b.p_W - a.p_W);
            const core::Vec3 along = (b.p_W - a.p_W).normalized() * half_m;
            const double radius_mm = 1e3 * (a.radius_m + t * (b.radius_m - a.radius_m)) + 0.18;
            addSweep(mesh,
                     {{1e3 * (middle - along), radius_mm, 1.0}, {1e3 * (middle + along), radius_mm, 1.0}},
                     SweepEnd::open, SweepEnd::open, kTubeSides);
            return;
        }
    }
}

} // namespace

TriangleMesh tubeMesh(const TubeCurve& curve) {
    TriangleMesh mesh;
    for (const TubePiece& piece : curve.pieces) {
        std::vector<SweepRing> rings;
        for (const TubeRing& ring : piece.rings) {
            const double lifted = std::clamp((ring.p_W.z() - ring.radius_m) / 0.010, 0.0, 1.0);
            const double light = 0.84 + 0.16 * lifted;
            rings.push_back({1e3 * ring.p_W, 1e3 * ring.radius_m, ring.pale > 0.0 ? 1.0 + ring.pale : light});
        }
        addSweep(mesh, rings, piece.first, piece.last, kTubeSides);
    }
    return mesh;
}

TriangleMesh tubeMarks(const TubeCurve& curve, const core::LaparoscopyCues& cues) {
    TriangleMesh mesh;
    for (const double quarter : {0.25, 0.5, 0.75})
        addSleeve(mesh, curve, quarter, 0.5 * kMark_m);
    for (int i = 0; i < cues.grips; ++i) {
        const auto k = static_cast<std::size_t>(i);
        if (cues.gripAnchored[k])
            continue;
        const double aside =
            cues.restLength_m > 0.0 ? 0.006 / cues.restLength_m : 0.0; // beside the jaws, not under them
        for (const double share : {cues.gripAt[k] - aside, cues.gripAt[k] + aside})
            if (share > 0.02 && share < 0.98)
                addSleeve(mesh, curve, share, kMark_m);
    }
    return mesh;
}

TriangleMesh tubeShade(const TubeCurve& curve, double floor_m) {
    TriangleMesh mesh;
    for (const TubePiece& piece : curve.pieces) {
        const std::vector<TubeRing>& rings = piece.rings;
        for (std::size_t k = 0; k < rings.size(); ++k) {
            const core::Vec2 at = rings[k].p_W.head<2>();
            const core::Vec2 way =
                (rings[std::min(k + 1, rings.size() - 1)].p_W - rings[k == 0 ? 0 : k - 1].p_W).head<2>();
            const core::Vec2 side = way.norm() > 1e-6 ? core::Vec2(core::Vec2(-way.y(), way.x()).normalized())
                                                      : core::Vec2(1.0, 0.0);
            const double above_m = rings[k].p_W.z() - rings[k].radius_m - floor_m;
            const double wide_m = 1.5 * rings[k].radius_m + 0.10 * std::max(0.0, above_m);
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.push_back(shadeVertex(at - wide_m * side, floor_m, 0.0));
            mesh.vertices.push_back(shadeVertex(at, floor_m, shadeOf(above_m)));
            mesh.vertices.push_back(shadeVertex(at + wide_m * side, floor_m, 0.0));
            if (k == 0)
                continue;
            for (std::uint32_t i : {first - 3, first - 2, first + 1, first - 3, first + 1, first, first - 2,
                                    first - 1, first + 2, first - 2, first + 2, first + 1})
                mesh.indices.push_back(i);
        }
    }
    return mesh;
}

} // namespace chiron::scene3d
