// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "cues/laparoscopy_cues.h"
#include "simulation/attributes/damping_budget.h"
#include "simulation/tube/tube_law.h"

#include <array>
#include <cstddef>

namespace chiron::simulation {

/// A tube before anything touches it.
struct TubeShape {
    static constexpr std::size_t kMaxNodes = core::LaparoscopyCues::kMaxGrips;
    TubeLaw law;
    double length_m = 0.045; ///< L₀, at rest
    double radius_m = 0.003; ///< it lies on the floor at this height
    /// Points that are fixed, an end, or where an instrument may grip.
    std::size_t nodes = 2;
    /// Position of each along the tube; first 0, last 1, ascending.
    std::array<double, kMaxNodes> share{0.0, 1.0};
    bool fixed = true; ///< node 0 is fixed to the floor, and the tube stands up from it
    /// Node 0 where it is fixed; otherwise the middle of the tube, which lies along x.
    core::Vec3 base = core::Vec3::Zero();
    double recovery_s = 0.1; ///< time constant with which a released part returns
};

/// How a node is held in this tick.
struct NodeHold {
    bool held = false;
    core::Vec3 p_W = core::Vec3::Zero();             ///< m
    core::Vec3 v_W = core::Vec3::Zero();             ///< m/s
    double mostDamping_Ns_per_m = kUnboundedDamping; ///< budget of its tool
};

/// Response of the tube.
struct TubeAnswer {
    /// Force on the holder of the node, N.
    std::array<core::Vec3, TubeShape::kMaxNodes> force{core::Vec3::Zero(), core::Vec3::Zero(),
                                                       core::Vec3::Zero()};
    /// Stiffness that the holder feels.
    std::array<double, TubeShape::kMaxNodes> stiffness_N_per_m{};
    /// Part of the holder's budget that is used.
    std::array<double, TubeShape::kMaxNodes> damping_Ns_per_m{};
    /// A segment at the node is stretched further than the law's limit, beyond which its tension stays.
    std::array<bool, TubeShape::kMaxNodes> beyondLimit{};
    double tension_N = 0.0; ///< largest along the tube
    double stretch_m = 0.0; ///< largest, expressed for the whole tube
    double energy_J = 0.0;  ///< elastic
};

/// A massless elastic tube between its holders (P2; models.md §2.4). It consists of straight segments between
/// fixed and held points, each with its tension and energy (tube_segment.h). Forces are therefore equal and
/// opposite and, without viscosity, the gradient of one potential over all hands.
///
/// A released part recoils with the time constant `recovery_s`: a free end returns to its rest position, and
/// a free point between two holders returns to its share of their chord. Its remaining pull decays in the
/// same way. The part is dragged along and never left behind, so the remaining stretch (or distance from that
/// position) only ever falls. A recoil thus costs energy and creates none, no force steps when a hand lets
/// go, and a free end that has settled pulls at nobody. A fixed tube's free end rests upright over the base,
/// or straight on from the grip beneath it. An unfixed tube's free end is dragged behind the other one and
/// sinks to the floor. Neither follows from a law of tissue; both are our choice.
///
/// Deterministic.
/// Thread: haptic; never allocates.
class TubeChain {
public:
    TubeChain() = default;
    explicit TubeChain(const TubeShape& shape) noexcept;

    using Holds = std::array<NodeHold, TubeShape::kMaxNodes>;
    /// Advances by one tick of 1 ms. A hold of the fixed node is ignored.
    TubeAnswer step(const Holds& holds) noexcept;

    /// Where a node is now and can be gripped: m, W. A free point between two others follows the bulge of a
    /// slack tube.
    const core::Vec3& place(std::size_t node) const noexcept { return m_p[node]; }
    /// Says whether nothing would pull at `node` if it were held at `p_W`.
    bool slackAt(std::size_t node, const core::Vec3& p_W) const noexcept;

    const TubeShape& shape() const noexcept { return m_shape; }

private:
    bool attached(std::size_t node) const noexcept {
        return m_holds[node].held || (m_shape.fixed && node == 0);
    }
    bool between(std::size_t node) const noexcept { return node > 0 && node + 1 < m_shape.nodes; }
    bool counts(std::size_t node) const noexcept {
        return !between(node) || m_holds[node].held || m_lag_m[node] > 0.0;
    }
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
    bool pulls(std::size_t node) const noexcept {
        return between(node) || attached(node) || m_over_m[node] > 0.0;
    }

    TubeShape m_shape;
    double m_share = 0.0; ///< share of a recoil that is completed in one tick
    Holds m_holds{};
    std::array<core::Vec3, TubeShape::kMaxNodes> m_p{core::Vec3::Zero(), core::Vec3::Zero(),
                                                     core::Vec3::Zero()};
    std::array<double, TubeShape::kMaxNodes> m_over_m{}; ///< of a free end: its remaining stretch
    /// Of a free point between: its remaining distance from its place on the chord.
    std::array<double, TubeShape::kMaxNodes> m_lag_m{};
};

} // namespace chiron::simulation
