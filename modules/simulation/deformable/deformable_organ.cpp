// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/deformable/deformable_organ.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

/// A smaller displacement leaves the normals at rest, since no edge is shorter than some tenths of a
/// millimetre.
constexpr double kStill_m = 1e-9;

core::Vec3 vec(const std::array<double, 3>& a) noexcept {
    return {a[0], a[1], a[2]};
}

} // namespace

void DeformableOrgan::restart(std::uint64_t tick) noexcept {
    ++m_epoch;
    m_blend.reset(tick);
    m_error = PredictionError();
    setWeights(tick);
}

bool DeformableOrgan::update(std::uint64_t tick, SlowUpdate when) noexcept {
    const bool applied = m_link.take(tick, when, *this);
    if (applied && m_link.answer().epoch == m_epoch) {
        m_answers[Link::slotOf(m_link.number())] = m_link.answer();
        compare(m_link.number());
        m_blend.apply(tick, m_link.postedAt_ticks(), m_link.number());
    }
    setWeights(tick);
    return applied;
}

void DeformableOrgan::ask(std::uint64_t tick, const OrganTouches& touches) noexcept {
    if (!m_link.mayPost(tick))
        return;
    m_link.post(tick, {m_epoch, touches});
    m_asked = touches;
    const BlendWeights held = m_blend.heldWeights(tick);
    for (std::size_t i = 0; i < touches.size(); ++i) {
        m_shown[i] = m_held[i] = core::Vec3::Zero();
        if (!touches[i].touching)
            continue;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = m_mesh.triangle(touches[i].triangle).vertex[corner];
            m_shown[i] += touches[i].weights[corner] * (position(vertex) - m_mesh.position(vertex));
        }
        m_held[i] = held.newest * displacementOf(m_blend.numbers()[0], touches[i]) +
                    held.previous * displacementOf(m_blend.numbers()[1], touches[i]);
    }
}

core::Vec3 DeformableOrgan::displacementOf(std::uint64_t number, const OrganTouch& touch) const noexcept {
    core::Vec3 sum = core::Vec3::Zero();
    if (number == 0) // at rest
        return sum;
    const std::vector<Moved>& slot = m_slots[Link::slotOf(number)];
    for (std::size_t corner = 0; corner < 3; ++corner)
        sum += touch.weights[corner] * slot[m_mesh.triangle(touch.triangle).vertex[corner]].displacement;
    return sum;
}

void DeformableOrgan::compare(std::uint64_t number) noexcept {
    m_error = PredictionError();
    for (std::size_t i = 0; i < m_asked.size(); ++i) {
        if (!m_asked[i].touching)
            continue;
        const core::Vec3 came = displacementOf(number, m_asked[i]);
        m_error.predicted_m = std::max(m_error.predicted_m, (m_shown[i] - came).norm());
        m_error.held_m = std::max(m_error.held_m, (m_held[i] - came).norm());
    }
}

void DeformableOrgan::setWeights(std::uint64_t tick) noexcept {
    const BlendWeights now = m_blends ? m_blend.weights(tick) : BlendWeights{};
    const std::array<double, 3> weights{now.newest, now.previous, now.before};
    m_largest_m = 0.0;
    m_energy_J = 0.0;
    m_moves = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint64_t number = m_blend.numbers()[i];
        const std::size_t slot = Link::slotOf(number);
        Share& share = m_shares[i];
        share.weight = weights[i];
        share.moved = number == 0 || weights[i] == 0.0 ? nullptr : m_slots[slot].data();
        if (share.moved == nullptr)
            continue;
        m_moves = true;
        m_largest_m += std::abs(weights[i]) * m_answers[slot].largest_m;
        m_energy_J += weights[i] * m_answers[slot].energy_J;
    }
    m_energy_J = std::max(0.0, m_energy_J);
}

core::Vec3 DeformableOrgan::position(std::uint32_t vertex) const noexcept {
    core::Vec3 place = m_mesh.position(vertex);
    if (m_moves)
        for (const Share& share : m_shares)
            if (share.moved != nullptr)
                place += share.weight * share.moved[vertex].displacement;
    return place;
}

core::Vec3 DeformableOrgan::normal(std::uint32_t vertex) const noexcept {
    if (!m_moves)
        return m_mesh.normal(vertex);
    core::Vec3 sum = core::Vec3::Zero();
    for (const Share& share : m_shares)
        sum += share.weight * (share.moved != nullptr ? share.moved[vertex].normal : m_mesh.normal(vertex));
    const double length = sum.norm();
    return length > 0.0 ? core::Vec3(sum / length) : m_mesh.normal(vertex);
}

bool DeformableOrgan::step() noexcept {
    return m_link.serve(
        [this](std::uint64_t number, const Request& request) noexcept { return solve(number, request); });
}

DeformableOrgan::Answer DeformableOrgan::solve(std::uint64_t number, const Request& request) noexcept {
    if (request.epoch != m_modelEpoch) {
        m_network->reset();
        m_modelEpoch = request.epoch;
    }
    std::array<NetworkPush, core::kMaxTools> pushes;
    std::size_t count = 0;
    for (const OrganTouch& touch : request.touches)
        if (touch.touching)
            pushes[count++] = {touch.triangle, touch.weights, vec(touch.normal), vec(touch.p_Tool),
                               touch.stiffness_N_per_m};
    m_network->step(std::span<const NetworkPush>(pushes.data(), count));

    std::vector<Moved>& slot = m_slots[Link::slotOf(number)];
    Answer answer;
    answer.epoch = request.epoch;
    answer.energy_J = m_network->elasticEnergy_J();
    double largest2 = 0.0;
    for (std::uint32_t vertex = 0; vertex < slot.size(); ++vertex) {
        slot[vertex].displacement = m_network->displacement(vertex);
        largest2 = std::max(largest2, slot[vertex].displacement.squaredNorm());
        m_places[vertex] = m_mesh.position(vertex) + slot[vertex].displacement;
    }
    const bool still = largest2 < kStill_m * kStill_m;
    if (!still)
        smoothNormals(m_mesh, m_angles, m_places, m_normals);
    for (std::uint32_t vertex = 0; vertex < slot.size(); ++vertex)
        slot[vertex].normal = still ? m_mesh.normal(vertex) : m_normals[vertex];
    answer.largest_m = std::sqrt(largest2);
    return answer;
}

} // namespace chiron::simulation
