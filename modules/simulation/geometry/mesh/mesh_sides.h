// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace chiron::simulation {

/// One side of a triangle. When sides are sorted by key, the triangles that share an edge are adjacent.
struct MeshSide {
    std::uint64_t key = 0; ///< lower vertex << 32 | higher vertex
    std::uint32_t triangle = 0;
    std::uint8_t opposite = 0; ///< the corner that it does not touch
    bool forward = false;      ///< the corner that is not on this side
};

/// Returns all sides of all triangles, sorted by key, then by triangle. Allocates.
std::vector<MeshSide> sortedSides(std::span<const std::array<std::uint32_t, 3>> triangles);

/// Calls `edge(sides)` for every group of sides that form one edge.
template <class Edge> void forEachEdge(std::span<const MeshSide> sides, Edge&& edge) {
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t end = i + 1;
        while (end < sides.size() && sides[end].key == sides[i].key)
            ++end;
        edge(sides.subspan(i, end - i));
        i = end;
    }
}

} // namespace chiron::simulation
