// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/elastic_tube/simulation/tube_chain.h"

#include "core/units.h"
#include "simulation/tube/tube_segment.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

/// The rest of a recoil below this is dropped; it is under 0.1 mN of any tube's pull.
constexpr double kSettled_m = 1e-7;

} // namespace

TubeChain::TubeChain(const TubeShape& shape) noexcept
    : m_shape(shape), m_share(1.0 - std::exp(-core::kTickSeconds / shape.recovery_s)) {
    const core::Vec3 along = shape.fixed ? core::Vec3::UnitZ() : core::Vec3::UnitX();
    core::Vec3 first = shape.base;
    if (!shape.fixed)
        first += core::Vec3(-0.5 * shape.length_m, 0.0, shape.radius_m);
    for (std::size_t i = 0; i < shape.nodes; ++i)
        m_p[i] = first + shape.share[i] * shape.length_m * along;
}

double TubeChain::rest_m(std::size_t a, std::size_t b) const noexcept {
    return std::abs(m_shape.share[b] - m_shape.share[a]) * m_shape.length_m;
}

/// The next node towards the other end that is held or fixed; the end itself if there is none.
std::size_t TubeChain::attachmentOf(std::size_t end) const noexcept {
    if (end == 0) {
        for (std::size_t i = 1; i < m_shape.nodes; ++i)
            if (attached(i))
                return i;
    } else {
        for (std::size_t i = end; i-- > 0;)
            if (attached(i))
                return i;
    }
    return end;
}

/// The next node on that side that has a position of its own.
std::size_t TubeChain::neighbour(std::size_t node, int step) const noexcept {
    std::size_t i = step < 0 ? node - 1 : node + 1;
    while (between(i) && !m_holds[i].held)
        i = step < 0 ? i - 1 : i + 1;
    return i;
}

/// The damping of a segment that the hands at both ends can bear. A place between two segments gives half its
/// budget to each, and two hands that move against each other meet twice the damping.
double TubeChain::mostDampingOf(std::size_t a, std::size_t b) const noexcept {
    const auto budget = [this](std::size_t node) {
        return m_holds[node].held ? m_holds[node].mostDamping_Ns_per_m * (between(node) ? 0.5 : 1.0)
                                  : kUnboundedDamping;
    };
    return std::min(budget(a), budget(b)) * (m_holds[a].held && m_holds[b].held ? 0.5 : 1.0);
}

core::Vec3 TubeChain::restingPlace(std::size_t end, std::size_t at) const noexcept {
    if (!m_shape.fixed)
        return {m_p[end].x(), m_p[end].y(), m_shape.radius_m};
    core::Vec3 along = core::Vec3::UnitZ();
    if (at != 0) {
        const core::Vec3 from = m_p[at] - m_p[0];
        const double length_m = from.norm();
        if (length_m > 1e-6)
            along = from / length_m;
    }
    return m_p[at] + rest_m(at, end) * along;
}

core::Vec3 TubeChain::placeBetween(std::size_t node) const noexcept {
    const std::size_t a = neighbour(node, -1);
    const std::size_t b = neighbour(node, 1);
    const double t = (m_shape.share[node] - m_shape.share[a]) / (m_shape.share[b] - m_shape.share[a]);
    return tubePlace(m_p[a], m_p[b], rest_m(a, b), t);
}

/// Keeps the present stretch when somebody takes hold or lets go, because recoils begin from it.
void TubeChain::remember(const Holds& holds) noexcept {
    bool changed = false;
    for (std::size_t i = 0; i < m_shape.nodes; ++i)
        changed = changed || (holds[i].held != m_holds[i].held && !(m_shape.fixed && i == 0));
    const Holds before = m_holds;
    m_holds = holds;
    if (m_shape.fixed)
        m_holds[0] = NodeHold{};
    if (!changed)
        return;
    for (std::size_t i = 0; i < m_shape.nodes; ++i) {
        m_over_m[i] = 0.0;
        if (m_holds[i].held)
            m_lag_m[i] = 0.0;
        else if (between(i) && before[i].held)
            m_lag_m[i] = (m_p[i] - placeBetween(i)).norm();
        else if (!between(i) && !attached(i)) {
            const std::size_t at = attachmentOf(i);
            if (at != i)
                m_over_m[i] = std::max(0.0, (m_p[i] - m_p[at]).norm() - rest_m(at, i));
        }
    }
}

void TubeChain::relaxEnd(std::size_t end) noexcept {
    const std::size_t at = attachmentOf(end);
    core::Vec3& p = m_p[end];
    if (at == end) { // nobody holds the tube
        p.z() += (m_shape.radius_m - p.z()) * m_share;
        return;
    }
    p += (restingPlace(end, at) - p) * m_share;
    const double rest = rest_m(at, end);
    const double most_m = rest + m_over_m[end] * (1.0 - m_share);
    const core::Vec3 from = m_p[at] - p;
    double chord_m = from.norm();
    if (chord_m > most_m) {
        p = m_p[at] - from * (most_m / chord_m);
        chord_m = most_m;
    }
    m_over_m[end] = std::max(0.0, chord_m - rest);
    if (m_over_m[end] < kSettled_m)
        m_over_m[end] = 0.0;
}

void TubeChain::relaxBetween(std::size_t node) noexcept {
    const core::Vec3 goal = placeBetween(node);
    const double most_m = m_lag_m[node] * (1.0 - m_share);
    core::Vec3 off = (m_p[node] - goal) * (1.0 - m_share);
    const double off_m = off.norm();
    if (off_m > most_m)
        off *= most_m / off_m;
    m_lag_m[node] = std::min(off_m, most_m);
    if (m_lag_m[node] < kSettled_m) {
        m_lag_m[node] = 0.0;
        off.setZero();
    }
    m_p[node] = goal + off;
}

/// Moves the held places first, then the places that follow them.
void TubeChain::move() noexcept {
    for (std::size_t i = 0; i < m_shape.nodes; ++i)
        if (m_holds[i].held)
            m_p[i] = m_holds[i].p_W;
    for (const std::size_t end : {std::size_t{0}, m_shape.nodes - 1})
        if (!attached(end))
            relaxEnd(end);
    for (std::size_t i = 1; i + 1 < m_shape.nodes; ++i)
        if (!m_holds[i].held)
            relaxBetween(i);
}

TubeAnswer TubeChain::step(const Holds& holds) noexcept {
    remember(holds);
    move();
    TubeAnswer answer;
    std::size_t a = 0;
    for (std::size_t b = 1; b < m_shape.nodes; ++b) {
        if (!counts(b))
            continue;
        if (pulls(a) && pulls(b)) {
            // A recoiling part does not have the velocity of a hand
            const bool damped = attached(a) && attached(b);
            const core::Vec3 rate =
                damped ? core::Vec3(m_holds[b].v_W - m_holds[a].v_W) : core::Vec3(core::Vec3::Zero());
            const SegmentPull pull = pullOf(m_shape.law, m_shape.length_m, rest_m(a, b), m_p[a], m_p[b], rate,
                                            mostDampingOf(a, b));
            const double felt =
                (damped ? pull.damping_Ns_per_m : 0.0) * (m_holds[a].held && m_holds[b].held ? 2.0 : 1.0);
            answer.damping_Ns_per_m[a] += felt;
            answer.damping_Ns_per_m[b] += felt;
            answer.force[a] += pull.onFirst;
            answer.force[b] -= pull.onFirst;
            answer.stiffness_N_per_m[a] += pull.stiffness_N_per_m;
            answer.stiffness_N_per_m[b] += pull.stiffness_N_per_m;
            if (pull.stretch_m > m_shape.law.limit_m)
                answer.beyondLimit[a] = answer.beyondLimit[b] = true;
            answer.tension_N = std::max(answer.tension_N, pull.tension_N);
            answer.stretch_m = std::max(answer.stretch_m, pull.stretch_m);
            answer.energy_J += pull.energy_J;
        }
        a = b;
    }
    return answer;
}

bool TubeChain::slackAt(std::size_t node, const core::Vec3& p_W) const noexcept {
    const auto slack = [&](std::size_t other) {
        const bool follows = !attached(other) && !between(other); // a free end follows
        return follows || (p_W - m_p[other]).norm() <= rest_m(node, other);
    };
    return (node == 0 || slack(neighbour(node, -1))) &&
           (node + 1 >= m_shape.nodes || slack(neighbour(node, 1)));
}

} // namespace chiron::simulation
