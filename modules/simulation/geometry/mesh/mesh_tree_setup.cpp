// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/mesh/mesh_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace chiron::simulation {

namespace {

float roundedDown(double x) {
    return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity());
}
float roundedUp(double x) {
    return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}

void include(MeshTree::Node& node, const std::array<core::Vec3, 3>& corners) {
    for (const core::Vec3& corner : corners)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double x = corner[static_cast<Eigen::Index>(axis)];
            node.low[axis] = std::min(node.low[axis], roundedDown(x));
            node.high[axis] = std::max(node.high[axis], roundedUp(x));
        }
}

int longestAxis(const std::vector<core::Vec3>& centres, std::span<const std::uint32_t> part) {
    core::Vec3 low = centres[part[0]];
    core::Vec3 high = low;
    for (const std::uint32_t t : part) {
        low = low.cwiseMin(centres[t]);
        high = high.cwiseMax(centres[t]);
    }
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    return static_cast<int>(axis);
}

struct Task {
    std::uint32_t node, first, count;
};

} // namespace

MeshTree::MeshTree(std::span<const std::array<core::Vec3, 3>> triangles, std::vector<std::uint32_t>& order) {
    if (triangles.empty())
        return;
    std::vector<core::Vec3> centres;
    centres.reserve(triangles.size());
    for (const auto& corners : triangles)
        centres.push_back((corners[0] + corners[1] + corners[2]) / 3.0);
    order.resize(triangles.size());
    std::iota(order.begin(), order.end(), 0U);
    m_nodes.reserve(triangles.size());
    m_nodes.emplace_back();
    std::vector<Task> tasks{{0, 0, static_cast<std::uint32_t>(triangles.size())}};
    constexpr float kFar = std::numeric_limits<float>::infinity();
    while (!tasks.empty()) {
        const Task task = tasks.back();
        tasks.pop_back();
        Node node{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}, task.first, task.count};
        const std::span<std::uint32_t> part(order.data() + task.first, task.count);
        for (const std::uint32_t t : part)
            include(node, triangles[t]);
        if (task.count > kLeaf) {
            const int axis = longestAxis(centres, part);
            const std::uint32_t half = task.count / 2;
            // the index breaks ties: the same triangles make the same tree
            std::nth_element(part.begin(), part.begin() + half, part.end(),
                             [&](std::uint32_t a, std::uint32_t b) {
                                 return std::tie(centres[a][axis], a) < std::tie(centres[b][axis], b);
                             });
            node.first = static_cast<std::uint32_t>(m_nodes.size());
            node.count = 0;
            m_nodes.resize(m_nodes.size() + 2);
            tasks.push_back({node.first, task.first, half});
            tasks.push_back({node.first + 1, task.first + half, task.count - half});
        }
        m_nodes[task.node] = node;
    }
}

} // namespace chiron::simulation
