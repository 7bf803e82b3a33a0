// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/station/faulty_line.h"

#include <algorithm>
#include <cmath>

namespace chiron::station {

FaultyLine::FaultyLine(const FaultPlan& plan, std::uint64_t seed)
    : m_plan(plan), m_begin_ms(static_cast<std::uint64_t>(std::lround(1000.0 * plan.when_s))),
      m_random(core::Random::mix(seed, "line")) {}

bool FaultyLine::acts(std::uint64_t now_ms) const noexcept {
    return m_plan.kind != FaultKind::none && now_ms >= m_begin_ms;
}

bool FaultyLine::during(FaultKind kind, std::uint64_t now_ms) const noexcept {
    return m_plan.kind == kind && acts(now_ms) && static_cast<double>(now_ms - m_begin_ms) < m_plan.amount;
}

bool FaultyLine::frozen(std::uint64_t now_ms) const noexcept {
    return during(FaultKind::freeze, now_ms);
}

bool FaultyLine::unplugged(std::uint64_t now_ms) const noexcept {
    const bool forGood = m_plan.kind == FaultKind::unplug && m_plan.amount == 0.0 && acts(now_ms);
    return forGood || during(FaultKind::unplug, now_ms);
}

void FaultyLine::damage(FrameBytes& frame) noexcept {
    const auto bit = static_cast<std::size_t>(m_random.uniform() * 8.0 * static_cast<double>(frame.size()));
    frame[std::min(bit / 8, frame.size() - 1)] ^= static_cast<std::uint8_t>(1u << (bit % 8));
}

void FaultyLine::push(const FrameBytes& frame, std::uint64_t now_ms) {
    if (!acts(now_ms)) {
        m_waiting.push_back({frame, now_ms});
        return;
    }
    std::uint64_t leaves_ms = now_ms;
    switch (m_plan.kind) {
    case FaultKind::delay:
        leaves_ms += static_cast<std::uint64_t>(std::lround(m_plan.amount));
        break;
    case FaultKind::jitter:
        leaves_ms += static_cast<std::uint64_t>(std::lround(m_plan.amount * m_random.uniform()));
        if (!m_waiting.empty())
            leaves_ms = std::max(leaves_ms, m_waiting.back().leaves_ms);
        break;
    case FaultKind::drop:
        if (draws())
            return;
        break;
    case FaultKind::duplicate:
        if (draws())
            m_waiting.push_back({frame, leaves_ms});
        break;
    case FaultKind::reorder:
        if (!m_waiting.empty() && m_waiting.back().leaves_ms > now_ms) { // one is held back: it follows this
            m_waiting.back().leaves_ms = now_ms;
            m_waiting.insert(m_waiting.end() - 1, {frame, now_ms});
            return;
        }
        if (draws())
            leaves_ms = now_ms + 1000; // until the next one comes
        break;
    case FaultKind::corrupt:
        m_waiting.push_back({frame, leaves_ms});
        if (draws())
            damage(m_waiting.back().frame);
        return;
    default:
        break;
    }
    m_waiting.push_back({frame, leaves_ms});
}

bool FaultyLine::pop(FrameBytes& frame, std::uint64_t now_ms) {
    if (m_waiting.empty() || m_waiting.front().leaves_ms > now_ms)
        return false;
    frame = m_waiting.front().frame;
    m_waiting.pop_front();
    return true;
}

bool FaultyLine::admits(FrameBytes& frame, std::uint64_t now_ms) {
    if (!acts(now_ms))
        return true;
    if (m_plan.kind == FaultKind::drop)
        return !draws();
    if (m_plan.kind == FaultKind::corrupt && draws())
        damage(frame);
    return true;
}

} // namespace chiron::station
