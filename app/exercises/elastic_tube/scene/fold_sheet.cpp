// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/elastic_tube/scene/fold_sheet.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

using core::Vec3;

constexpr int kRows = FoldSheet::kEdgeRow; // number of rows from the root to the edge
constexpr double kRootBehind_m = 0.042;    // distance behind the point over which the edge hangs
constexpr double kRootHalf_m = 0.040;      // half the width at the root …
constexpr double kEdgeHalf_m = 0.032;      // … and at the edge
constexpr double kHem_m = 0.012;           // length of the hem that hangs down beyond the edge
constexpr double kWave_m = 0.0012;         // amplitude of the waves in the sheet
constexpr double kLow_m = 0.0012;          // smallest height over the floor

Vec3 vecOf(const std::array<double, 3>& p) {
    return {p[0], p[1], p[2]};
}

} // namespace

FoldSheet FoldSheet::of(const core::LaparoscopyCues& cues) {
    FoldSheet sheet;
    if (!cues.present || !cues.fold)
        return sheet;
    const Vec3 edge = vecOf(cues.p_WFoldEdge), base = vecOf(cues.p_WFoldBase);
    const Vec3 root(base.x(), base.y() + kRootBehind_m, kLow_m);
    const Vec3 way = edge - root;
    const bool held = cues.foldHeldBy != 0;
    const Vec3 forward = Vec3(way.x(), way.y(), 0.0).norm() > 1e-6
                             ? Vec3(Vec3(way.x(), way.y(), 0.0).normalized())
                             : Vec3(-Vec3::UnitY());
    for (int k = 0; k <= kRows + kRows / 3; ++k) {
        const double along = static_cast<double>(k) / kRows; // 1 at the edge
        const double hem = std::max(0.0, along - 1.0) * 3.0; // 0..1
        auto& row = sheet.rows.emplace_back();
        for (int c = 0; c < kColumns; ++c) {
            const double across = 2.0 * c / (kColumns - 1) - 1.0;
            // The fold is held at its middle, so its corners hang down.
            const double gripped = held ? std::exp(-6.0 * across * across) : 1.0;
            const double half = kRootHalf_m + std::min(along, 1.0) * (kEdgeHalf_m - kRootHalf_m);
            const double share = std::min(along, 1.0);
            Vec3 p = root + share * way;
            p.z() += (held ? 0.10 : 0.25) * share * (1.0 - share) * 0.04;
            p.z() -= share * (1.0 - gripped) * 0.45 * std::max(0.0, p.z() - kLow_m);
            p += kWave_m * std::sin(2.5 * core::kPi * across) * share * Vec3::UnitZ();
            p += hem * kHem_m * (0.5 * forward - 0.8 * Vec3::UnitZ());
            p.x() += across * half;
            p.z() = std::max(p.z(), kLow_m);
            row[static_cast<std::size_t>(c)] = p;
        }
    }
    return sheet;
}

TriangleMesh foldMesh(const FoldSheet& sheet, double pale) {
    TriangleMesh mesh;
    const auto columns = static_cast<std::uint32_t>(FoldSheet::kColumns);
    const auto at = [&](std::size_t r, std::size_t c) -> const Vec3& { return sheet.rows[r][c]; };
    for (const double side : {1.0, -1.0}) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (std::size_t r = 0; r < sheet.rows.size(); ++r)
            for (std::size_t c = 0; c < FoldSheet::kColumns; ++c) {
                const Vec3 down = at(std::min(r + 1, sheet.rows.size() - 1), c) - at(r > 0 ? r - 1 : 0, c);
                const Vec3 wide =
                    at(r, std::min<std::size_t>(c + 1, FoldSheet::kColumns - 1)) - at(r, c > 0 ? c - 1 : 0);
                // Rows come forward and columns go right, so this vector points up.
                const Vec3 across = down.cross(wide);
                const Vec3 n = side * (across.norm() > 0.0 ? Vec3(across.normalized()) : Vec3(Vec3::UnitZ()));
                const Vec3 p = 1e3 * at(r, c) + 0.3 * n;
                MeshVertex v;
                for (int k = 0; k < 3; ++k) {
                    v.position_mm[k] = static_cast<float>(p[k]);
                    v.normal[k] = static_cast<float>(n[k]);
                }
                v.texture[0] = v.position_mm[0];
                v.texture[1] = v.position_mm[1];
                v.light = static_cast<float>(pale > 0.0 ? 1.0 + pale : 0.95);
                mesh.vertices.push_back(v);
            }
        for (std::uint32_t r = 0; r + 1 < sheet.rows.size(); ++r)
            for (std::uint32_t c = 0; c + 1 < columns; ++c) {
                const std::uint32_t a = first + r * columns + c, b = a + 1, d = a + columns, e = d + 1;
                if (side > 0.0)
                    mesh.indices.insert(mesh.indices.end(), {a, d, b, b, d, e});
                else
                    mesh.indices.insert(mesh.indices.end(), {a, b, d, b, e, d});
            }
    }
    return mesh;
}

} // namespace chiron::scene3d
