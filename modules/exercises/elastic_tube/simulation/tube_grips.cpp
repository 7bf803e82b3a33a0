// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/elastic_tube/simulation/tube_grips.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

/// A slack tube slides into the jaws within a tenth of a second: this looks like one movement and is not
/// felt. Our choice.
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

TubeGrips::Change TubeGrips::update(const core::ToolStates& tools, const TubeChain& tube,
                                    const Takers& takers) noexcept {
    Change change;
    const int used = std::min(std::clamp(tools.count, 0, core::kMaxTools), takers.end);
    for (auto i = static_cast<std::size_t>(takers.first); i < static_cast<std::size_t>(used); ++i) {
        const core::ToolState& tool = tools.tools[i];
        const int found = m_held[i] == kNobody && takers.free ? nearestFree(tool.p_WT, tube) : kNobody;
        switch (m_jaws[i].update(tool.jaw_rad, m_settings.holdsBelow_rad, m_settings.opensAbove_rad,
                                 found != kNobody)) {
        case GraspChange::grasped:
            m_held[i] = found;
            m_holder[static_cast<std::size_t>(found)] = static_cast<int>(i);
            m_offset[i] = tube.place(static_cast<std::size_t>(found)) - tool.p_WT;
            change.grasped = true;
            break;
        case GraspChange::released:
            m_holder[static_cast<std::size_t>(m_held[i])] = kNobody;
            m_holds[static_cast<std::size_t>(m_held[i])] = NodeHold{};
            m_held[i] = kNobody;
            change.released = true;
            break;
        case GraspChange::none:
            break;
        }
        if (m_held[i] != kNobody)
            follow(i, tool, tube);
    }
    return change;
}

int TubeGrips::nearestFree(const core::Vec3& p_WT, const TubeChain& tube) const noexcept {
    if (!p_WT.allFinite())
        return kNobody;
    double nearest_m = m_settings.reach_m;
    int found = kNobody;
    for (std::size_t node = tube.shape().fixed ? 1 : 0; node < tube.shape().nodes; ++node) {
        const double distance_m = (tube.place(node) - p_WT).norm();
        if (m_holder[node] != kNobody || distance_m > nearest_m)
            continue;
        nearest_m = distance_m;
        found = static_cast<int>(node);
    }
    return found;
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
