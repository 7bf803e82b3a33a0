// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/safety_sample_sanity.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::haptics {

namespace {

bool isSamePacket(const core::DeviceSample& a, const core::DeviceSample& b) noexcept {
    return a.packet == b.packet && a.counts == b.counts && a.jawCounts == b.jawCounts &&
           a.buttons == b.buttons && a.deviceTime_us == b.deviceTime_us && a.status == b.status;
}

/// Packet numbers wrap around: a packet is newer if it is ahead by less than half the range.
bool isNewer(std::uint32_t packet, std::uint32_t than) noexcept {
    return static_cast<std::int32_t>(packet - than) > 0;
}

} // namespace

void SafetySampleSanity::reset(const SafetySettings& settings, std::uint32_t period_us,
                               bool guarded) noexcept {
    *this = SafetySampleSanity();
    m_jump_m = settings.jump_m;
    m_quaternionTolerance = settings.quaternionTolerance;
    m_period_us = std::max<std::uint32_t>(period_us, 1);
    m_guarded = guarded;
}

void SafetySampleSanity::forgetReference() noexcept {
    m_hasReference = false;
    m_bad = 0;
    // If the last packet was refused, it is checked again: after a jump the tool may really be where it
    // reports.
    m_hasSeen = m_hasSeen && m_seenWasGood;
}

Admission SafetySampleSanity::admit(const realtime::HapticTick& now, const core::DeviceSample& sample,
                                    const core::ToolState& pose_D, std::uint32_t age_us) noexcept {
    m_dropped = false;
    if (m_hasSeen && isSamePacket(sample, m_seen)) {
        m_age_us = m_seenWasGood ? age_us : goodAge(now);
        return Admission::repeated;
    }
    m_seen = sample;
    m_hasSeen = true;
    m_seenWasGood = !m_guarded || isSane(now, sample, pose_D);
    if (!m_seenWasGood) {
        m_dropped = true;
        m_bad = m_bad == std::numeric_limits<std::uint32_t>::max() ? m_bad : m_bad + 1;
        m_age_us = goodAge(now);
        return Admission::dropped;
    }
    m_bad = 0;
    m_good = sample;
    for (int i = 0; i < 3; ++i) {
        m_goodPosition_m[i] = pose_D.p_WT[i];
    }
    m_goodTick = now.index();
    m_goodArrival_us = now.now_ns() / 1000 - static_cast<std::int64_t>(age_us);
    m_hasGood = true;
    m_hasReference = true;
    m_age_us = age_us;
    return Admission::fresh;
}

bool SafetySampleSanity::isSane(const realtime::HapticTick& now, const core::DeviceSample& sample,
                                const core::ToolState& pose_D) const noexcept {
    if ((sample.status & core::sample_status::kInvalid) != 0 || !pose_D.p_WT.allFinite() ||
        !std::isfinite(pose_D.jaw_rad)) {
        return false;
    }
    // The comparisons are negated, so that a NaN counts as bad.
    if (!(std::abs(pose_D.q_WT.coeffs().norm() - 1.0) <= m_quaternionTolerance)) {
        return false;
    }
    if (!m_hasReference) {
        return true;
    }
    if (!isNewer(sample.packet, m_good.packet)) {
        return false;
    }
    const std::uint64_t byPackets = sample.packet - m_good.packet;
    const std::uint64_t ticks = std::min<std::uint64_t>(now.index() - m_goodTick, 1'000'000'000);
    const std::uint64_t byTicks = 1 + ticks * 1000 / m_period_us;
    const double periods = static_cast<double>(std::min(byPackets, byTicks));
    const core::Vec3 moved =
        pose_D.p_WT - core::Vec3(m_goodPosition_m[0], m_goodPosition_m[1], m_goodPosition_m[2]);
    return moved.norm() <= m_jump_m * periods;
}

std::uint32_t SafetySampleSanity::goodAge(const realtime::HapticTick& now) const noexcept {
    if (!m_hasGood) {
        return 0;
    }
    const std::int64_t age = now.now_ns() / 1000 - m_goodArrival_us;
    constexpr std::int64_t kMost = std::numeric_limits<std::uint32_t>::max();
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(age, 0, kMost));
}

} // namespace chiron::haptics
