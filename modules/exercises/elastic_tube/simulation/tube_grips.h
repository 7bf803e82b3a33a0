// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"
#include "modules/exercises/elastic_tube/simulation/tube_chain.h"
#include "simulation/objects/grasp.h"

#include <array>
#include <cstdint>

namespace chiron::simulation {

/// When a jaw takes hold of a tube and when it lets go.
struct TubeGraspSettings {
    double reach_m = 0.007;        ///< how near to a place of the tube the tip has to be
    double holdsBelow_rad = 0.20;  ///< the jaw takes hold when it closes to this angle
    double opensAbove_rad = 0.35;  ///< and lets go when it opens to this one: hysteresis
};

/// Which instrument holds which place of a tube. A jaw that closes takes hold of the nearest free place within reach; one that
/// has closed on nothing has to open first. One instrument a place, one place an instrument; the fixed end cannot be held.
/// Taking hold leaves the tube as it is: the place keeps its distance from the tip (in W), so no force steps. While the tube
/// is slack there that distance closes, without pulling at anything.
/// A pose that is not a number leaves its place where it was. Deterministic. Thread: haptic. Never allocates.
class TubeGrips {
public:
    static constexpr int kNobody = -1;

    /// Everything let go; jaws have to open before they can take hold.
    void reset(const TubeGraspSettings& settings) noexcept;

    struct Change {
        bool grasped = false;
        bool released = false;
    };
    /// Who may take hold of it: tools [first, end), as long as nothing lies over it.
    struct Takers {
        int first = 0;
        int end = core::kMaxTools;
        bool free = true;
    };
    /// One tick: what the jaws do to a tube as it is now.
    Change update(const core::ToolStates& tools, const TubeChain& tube, const Takers& takers) noexcept;
    Change update(const core::ToolStates& tools, const TubeChain& tube) noexcept { return update(tools, tube, Takers()); }

    TubeChain::Holds holds() const noexcept { return m_holds; }
    int holderOf(std::size_t node) const noexcept { return m_holder[node]; }  ///< a tool, or kNobody
    int nodeOf(std::size_t tool) const noexcept { return m_held[tool]; }      ///< a place, or kNobody
    int count() const noexcept;                                               ///< places that are held

private:
    int nearestFree(const core::Vec3& p_WT, const TubeChain& tube) const noexcept;
    void follow(std::size_t tool, const core::ToolState& state, const TubeChain& tube) noexcept;

    TubeGraspSettings m_settings;
    std::array<GraspLatch, core::kMaxTools> m_jaws{};
    std::array<int, core::kMaxTools> m_held{kNobody, kNobody, kNobody, kNobody};
    std::array<core::Vec3, core::kMaxTools> m_offset{core::Vec3::Zero(), core::Vec3::Zero(), core::Vec3::Zero(), core::Vec3::Zero()};
    std::array<int, TubeShape::kMaxNodes> m_holder{kNobody, kNobody, kNobody};
    TubeChain::Holds m_holds{};
};

} // namespace chiron::simulation
