// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/laparoscopy_cues.h"
#include "simulation/attributes/damping_budget.h"
#include "simulation/tube/tube_law.h"

#include <array>
#include <cstddef>

namespace chiron::simulation {

/// A tube before anybody touches it.
struct TubeShape {
    static constexpr std::size_t kMaxNodes = core::LaparoscopyCues::kMaxGrips;
    TubeLaw law;
    double length_m = 0.045;                       ///< L₀, at rest
    double radius_m = 0.003;                       ///< it lies this high on the floor
    std::size_t nodes = 2;                         ///< places that are fixed, an end, or where an instrument may grip
    std::array<double, kMaxNodes> share{0.0, 1.0}; ///< of each along the tube; first 0, last 1, rising
    bool fixed = true;                             ///< node 0 is fixed to the floor, and the tube stands up from it
    core::Vec3 base = core::Vec3::Zero();          ///< node 0 where it is fixed; else the middle of where the tube lies along x
    double recovery_s = 0.1;                       ///< what was let go comes back with this time constant
};

/// What holds a node this tick.
struct NodeHold {
    bool held = false;
    core::Vec3 p_W = core::Vec3::Zero(); ///< m
    core::Vec3 v_W = core::Vec3::Zero(); ///< m/s
    double mostDamping_Ns_per_m = kUnboundedDamping; ///< its tool's budget
};

/// What the tube answers.
struct TubeAnswer {
    std::array<core::Vec3, TubeShape::kMaxNodes> force{core::Vec3::Zero(), core::Vec3::Zero(), core::Vec3::Zero()}; ///< N, on what holds the node
    std::array<double, TubeShape::kMaxNodes> stiffness_N_per_m{};                                                   ///< that it feels
    std::array<double, TubeShape::kMaxNodes> damping_Ns_per_m{};                                                    ///< that it uses
    double tension_N = 0.0; ///< largest along the tube
    double stretch_m = 0.0; ///< largest, as of the whole tube
    double energy_J = 0.0;  ///< elastic
};

/// A massless elastic tube between what holds it (P2; models.md §2.4): straight segments between fixed and held places, each
/// with its tension and energy (tube_segment.h), so that forces are equal and opposite and, without viscosity, the gradient
/// of one potential over all hands.
///
/// What is let go recoils: a free end comes back to where it rests, a free place between two holders to its share of their
/// chord, with the time constant `recovery_s`, and what it still pulls with dies out alike. It is dragged along, never left behind: the
/// remaining stretch (or distance from that place) only ever falls, so a recoil costs energy and makes none, no force steps
/// when a hand lets go, and once settled a free end pulls at nobody.
/// A fixed tube's free end rests upright over the base, or straight on from the grip beneath it; an unfixed tube's free end
/// is dragged behind the other one and sinks to the floor. Both follow from no law of tissue: they are ours.
///
/// Deterministic. Thread: haptic. Never allocates.
class TubeChain {
public:
    TubeChain() = default;
    explicit TubeChain(const TubeShape& shape) noexcept;

    using Holds = std::array<NodeHold, TubeShape::kMaxNodes>;
    /// One tick of 1 ms. A hold of the fixed node is passed over.
    TubeAnswer step(const Holds& holds) noexcept;

    /// Where a node is, and can be gripped, now: m, W. A free place between two others follows the bulge of a slack tube.
    const core::Vec3& place(std::size_t node) const noexcept { return m_p[node]; }
    /// Whether nothing would pull at `node`, were it held at `p_W`.
    bool slackAt(std::size_t node, const core::Vec3& p_W) const noexcept;

    const TubeShape& shape() const noexcept { return m_shape; }

private:
    bool attached(std::size_t node) const noexcept { return m_holds[node].held || (m_shape.fixed && node == 0); }
    bool between(std::size_t node) const noexcept { return node > 0 && node + 1 < m_shape.nodes; }
    bool counts(std::size_t node) const noexcept { return !between(node) || m_holds[node].held || m_lag_m[node] > 0.0; }
    double rest_m(std::size_t a, std::size_t b) const noexcept;
    std::size_t attachmentOf(std::size_t end) const noexcept;
    double mostDampingOf(std::size_t a, std::size_t b) const noexcept;
    std::size_t neighbour(std::size_t node, int step) const noexcept;
    core::Vec3 restingPlace(std::size_t end, std::size_t at) const noexcept;
    core::Vec3 placeBetween(std::size_t node) const noexcept;
    void remember(const Holds& holds) noexcept;
    void move() noexcept;
    void relaxEnd(std::size_t end) noexcept;
    void relaxBetween(std::size_t node) noexcept;
    bool pulls(std::size_t node) const noexcept { return between(node) || attached(node) || m_over_m[node] > 0.0; }

    TubeShape m_shape;
    double m_share = 0.0; ///< of a recoil that is done in one tick
    Holds m_holds{};
    std::array<core::Vec3, TubeShape::kMaxNodes> m_p{core::Vec3::Zero(), core::Vec3::Zero(), core::Vec3::Zero()};
    std::array<double, TubeShape::kMaxNodes> m_over_m{}; ///< of a free end: by how much it is still stretched
    std::array<double, TubeShape::kMaxNodes> m_lag_m{};  ///< of a free place between: how far it still is from there
};

} // namespace chiron::simulation
