// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace chiron::simulation {

/// A tree of bounding boxes of triangles, which finds the nearest triangle without looking at all of them.
/// Every box is halved until it holds only a few triangles. Boxes are floats rounded outward, 32 bytes per
/// node. They are halved at the median, so the depth is at most log2 of the number of triangles.
class MeshTree {
public:
    /// Capacity of a traversal's stack; medians of 2³² triangles need 32.
    static constexpr int kMostDepth = 48;
    static constexpr std::uint32_t kLeaf = 4; ///< most triangles in a leaf

    struct Node {
        std::array<float, 3> low{};
        std::array<float, 3> high{};
        /// Of a leaf: its first triangle; otherwise its two children are first and first + 1.
        std::uint32_t first = 0;
        std::uint32_t count = 0; ///< number of triangles in a leaf; 0: not a leaf

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
    /// Builds the tree from three corners per triangle, in metres. `order` says how the caller has to reorder
    /// the triangles for the tree to be valid: the one now at order[i] becomes the i-th. Triangles that are
    /// close in space are then close in memory. Deterministic. Allocates.
    MeshTree(std::span<const std::array<core::Vec3, 3>> triangles, std::vector<std::uint32_t>& order);

    /// The root first; empty if there are no triangles.
    std::span<const Node> nodes() const noexcept { return m_nodes; }

private:
    std::vector<Node> m_nodes;
};

} // namespace chiron::simulation
