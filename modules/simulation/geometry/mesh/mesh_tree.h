// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace chiron::simulation {

/// Boxes round triangles, halved down to a few of them: finds the nearest triangle without looking at all of them. Boxes are
/// floats rounded outward, 32 bytes a node; halved at the median, so that its depth is at most log2 of the triangles.
class MeshTree {
public:
    static constexpr int kMostDepth = 48;      ///< of a traversal's stack; medians of 2³² triangles need 32
    static constexpr std::uint32_t kLeaf = 4;  ///< triangles in a leaf, at most

    struct Node {
        std::array<float, 3> low{};
        std::array<float, 3> high{};
        std::uint32_t first = 0; ///< of a leaf: its first triangle; else its two children, first and first + 1
        std::uint32_t count = 0; ///< triangles of a leaf; 0: no leaf

        /// Square of the distance (m²) from p to the box.
        double distance2(const core::Vec3& p) const noexcept {
            double sum = 0.0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double x = p[static_cast<Eigen::Index>(axis)];
                const double below = static_cast<double>(low[axis]) - x;
                const double above = x - static_cast<double>(high[axis]);
                const double out = below > 0.0 ? below : (above > 0.0 ? above : 0.0);
                sum += out * out;
            }
            return sum;
        }
    };

    MeshTree() = default;
    /// Three corners a triangle, in metres. `order` is where the triangles have to go for the tree to hold: the one now at
    /// order[i] comes i-th. So what lies together in space lies together in memory. Allocates; deterministic.
    MeshTree(std::span<const std::array<core::Vec3, 3>> triangles, std::vector<std::uint32_t>& order);

    std::span<const Node> nodes() const noexcept { return m_nodes; } ///< the root first; none for no triangles

private:
    std::vector<Node> m_nodes;
};

} // namespace chiron::simulation
