// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/mesh/mesh_sides.h"

#include <algorithm>
#include <tuple>

namespace chiron::simulation {

std::vector<MeshSide> sortedSides(std::span<const std::array<std::uint32_t, 3>> triangles) {
    std::vector<MeshSide> sides;
    sides.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        for (std::uint8_t i = 0; i < 3; ++i) {
            const std::uint32_t from = triangles[t][(i + 1U) % 3], to = triangles[t][(i + 2U) % 3];
            const std::uint64_t low = std::min(from, to), high = std::max(from, to);
            sides.push_back({low << 32U | high, t, i, from < to});
        }
    std::sort(sides.begin(), sides.end(), [](const MeshSide& a, const MeshSide& b) {
        return std::tie(a.key, a.triangle, a.opposite) < std::tie(b.key, b.triangle, b.opposite);
    });
    return sides;
}

} // namespace chiron::simulation
