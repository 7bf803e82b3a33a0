// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/exercises/elastic_tube/tube_grips.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

/// A tenth of a second to slide into the jaws while slack: seen as one movement, felt as nothing. Ours.
constexpr double kSlideShare = core::kTickSeconds / 0.1;

} // namespace

void TubeGrips::reset(const TubeGraspSettings& settings) noexcept {
    *this = TubeGrips();
    m_settings = settings;
}

int TubeGrips::count() const noexcept {
    int held = 0;
    for (const int holder : m_holder)
        held += holder == kNobody ? 0 : 1;
    return held;
}

TubeGrips::Change TubeGrips::update(const core::ToolStates& tools, const TubeChain& tube) noexcept {
    Change change;
    const int used = std::clamp(tools.count, 0, core::kMaxTools);
    for (std::size_t i = 0; i < static_cast<std::size_t>(used); ++i) {
        const core::ToolState& tool = tools.tools[i];
        if (m_held[i] != kNobody) {
            if (tool.jaw_rad >= m_settings.opensAbove_rad) {
                const auto node = static_cast<std::size_t>(m_held[i]);
                m_holder[node] = kNobody;
                m_holds[node] = NodeHold{};
                m_held[i] = kNobody;
                m_opened[i] = true;
                change.released = true;
            }
        } else if (tool.jaw_rad >= m_settings.opensAbove_rad) {
            m_opened[i] = true;
        } else if (m_opened[i] && tool.jaw_rad <= m_settings.holdsBelow_rad) {
            m_opened[i] = false;
            if (tool.p_WT.allFinite() && take(i, tool.p_WT, tube))
                change.grasped = true;
        }
        if (m_held[i] != kNobody)
            follow(i, tool, tube);
    }
    return change;
}

bool TubeGrips::take(std::size_t tool, const core::Vec3& p_WT, const TubeChain& tube) noexcept {
    double nearest_m = m_settings.reach_m;
    int found = kNobody;
    for (std::size_t node = tube.shape().fixed ? 1 : 0; node < tube.shape().nodes; ++node) {
        const double distance_m = (tube.place(node) - p_WT).norm();
        if (m_holder[node] != kNobody || distance_m > nearest_m)
            continue;
        nearest_m = distance_m;
        found = static_cast<int>(node);
    }
    if (found == kNobody)
        return false;
    m_held[tool] = found;
    m_holder[static_cast<std::size_t>(found)] = static_cast<int>(tool);
    m_offset[tool] = tube.place(static_cast<std::size_t>(found)) - p_WT;
    return true;
}

void TubeGrips::follow(std::size_t tool, const core::ToolState& state, const TubeChain& tube) noexcept {
    const auto node = static_cast<std::size_t>(m_held[tool]);
    NodeHold& hold = m_holds[node];
    hold.held = true;
    if (!state.p_WT.allFinite() || !state.v_WT.allFinite()) {
        hold.v_W.setZero();
        return;
    }
    const core::Vec3 nearer = m_offset[tool] * (1.0 - kSlideShare);
    if (tube.slackAt(node, state.p_WT + m_offset[tool]) && tube.slackAt(node, state.p_WT + nearer))
        m_offset[tool] = nearer;
    hold.p_W = state.p_WT + m_offset[tool];
    hold.v_W = state.v_WT;
}

} // namespace chiron::simulation
