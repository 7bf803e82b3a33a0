// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"
#include "modules/exercises/elastic_tube/simulation/tube_chain.h"
#include "simulation/objects/grasp.h"

#include <array>
#include <cstdint>

namespace chiron::simulation {

/// Thresholds at which a jaw takes hold of a tube and lets go.
struct TubeGraspSettings {
    double reach_m = 0.007;       ///< greatest distance of the tip from a place of the tube
    double holdsBelow_rad = 0.20; ///< the jaw takes hold when it closes to this angle
    double opensAbove_rad = 0.35; ///< and lets go when it opens to this angle: hysteresis
};

/// Keeps track of which instrument holds which place of a tube. A jaw that closes takes hold of the nearest
/// free place within reach; a jaw that has closed on nothing has to open first. Each place has at most one
/// instrument and each instrument at most one place; the fixed end cannot be held. Taking hold leaves the
/// tube as it is: the place keeps its distance from the tip (in W), so no force steps. While the tube is
/// slack there, that distance closes without a pull on anything. If a pose is not finite, the place stays
/// where it was. Deterministic.
/// Thread: haptic; never allocates.
class TubeGrips {
public:
    static constexpr int kNobody = -1;

    /// Lets go of everything; jaws have to open before they can take hold.
    void reset(const TubeGraspSettings& settings) noexcept;

    struct Change {
        bool grasped = false;
        bool released = false;
    };
    /// The tools that may take hold of the tube: [first, end), as long as nothing lies over it.
    struct Takers {
        int first = 0;
        int end = core::kMaxTools;
        bool free = true;
    };
    /// Advances by one tick: applies the jaws to the tube in its present state.
    Change update(const core::ToolStates& tools, const TubeChain& tube, const Takers& takers) noexcept;
    Change update(const core::ToolStates& tools, const TubeChain& tube) noexcept {
        return update(tools, tube, Takers());
    }

    TubeChain::Holds holds() const noexcept { return m_holds; }
    int holderOf(std::size_t node) const noexcept { return m_holder[node]; } ///< a tool, or kNobody
    int nodeOf(std::size_t tool) const noexcept { return m_held[tool]; }     ///< a place, or kNobody
    /// Number of places that are held.
    int count() const noexcept;

private:
    int nearestFree(const core::Vec3& p_WT, const TubeChain& tube) const noexcept;
    void follow(std::size_t tool, const core::ToolState& state, const TubeChain& tube) noexcept;

    TubeGraspSettings m_settings;
    std::array<GraspLatch, core::kMaxTools> m_jaws{};
    std::array<int, core::kMaxTools> m_held{kNobody, kNobody, kNobody, kNobody};
    std::array<core::Vec3, core::kMaxTools> m_offset{core::Vec3::Zero(), core::Vec3::Zero(),
                                                     core::Vec3::Zero(), core::Vec3::Zero()};
    std::array<int, TubeShape::kMaxNodes> m_holder{kNobody, kNobody, kNobody};
    TubeChain::Holds m_holds{};
};

} // namespace chiron::simulation
