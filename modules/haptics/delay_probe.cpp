// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/delay_probe.h"

#include "core/units.h"

#include <cmath>

namespace chiron::haptics {

namespace {

constexpr int kRise_ticks = 100;   ///< rise to full force
constexpr int kSettle_ticks = 250; ///< by then the hand's own motion with the tool, at 2-5 Hz, has died away
constexpr int kGap_ticks = 150;    ///< pause without force
/// Ticks at least this far apart have a skipped one between them: ticks are at least half a period apart, and
/// late by less than that.
constexpr std::int64_t kTwoTicks_ns = 1'700'000;
/// In 32nds of a turn. Out of 3000 random starts, each improved one phase at a time, these have the lowest
/// peak: 3.15 times the amplitude of the highest sine (the amplitudes add up to 5.1 times).
constexpr std::array<double, DelayRecord::kFrequencies_Hz.size()> kPhase{14, 16, 23, 7, 28, 21, 28, 20, 4};
constexpr int kBurst_ticks = kSettle_ticks + DelayRecord::kWindow_ticks;

} // namespace

void DelayProbe::respond(const realtime::HapticTick&, const simulation::SceneInput& in,
                         simulation::SceneOutput& out) noexcept {
    out = simulation::SceneOutput{};
    out.tissue.count = in.tools.count;
    if (m_phase == core::TrialPhase::idle && in.started)
        m_phase = core::TrialPhase::ready;
    if (m_phase == core::TrialPhase::ready && in.forceReady)
        m_phase = core::TrialPhase::running;
    m_record.writing = false;
    if (m_phase == core::TrialPhase::running && !in.paused && in.tools.count > 0) {
        if (m_tick < kBurst_ticks)
            out.tissue.tools[0].force = force_N(m_tick) * m_settings.axis_W;
        if (m_tick >= kSettle_ticks && m_tick < kBurst_ticks)
            m_record.place(in.tools.tools[0].p_WT.dot(m_settings.axis_W));
        if (++m_tick == kBurst_ticks + kGap_ticks) {
            m_tick = 0;
            if (++m_burst == m_settings.bursts)
                m_phase = core::TrialPhase::finished;
        }
    }
    out.phase = m_phase;
}

std::uint64_t DelayProbe::ticksOf(const DelayProbeSettings& settings) noexcept {
    return static_cast<std::uint64_t>(settings.bursts) * (kBurst_ticks + kGap_ticks);
}

double DelayProbe::force_N(int tick) const noexcept {
    const double rise = tick < kRise_ticks ? 0.5 * (1.0 - std::cos(core::kPi * tick / kRise_ticks)) : 1.0;
    const auto& all = DelayRecord::kFrequencies_Hz;
    double sum = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        sum += all[i] / all.back() *
               std::cos(2.0 * core::kPi * (all[i] * core::kTickSeconds * tick + kPhase[i] / 32.0));
    }
    return m_settings.force_N * rise * sum;
}

bool DelayListener::tryPush(const core::HapticFrame& frame) noexcept {
    if (m_record.writing) {
        const core::Array6& f = frame.tool[0].commanded;
        m_record.force(core::Vec3(f[0], f[1], f[2]).dot(m_axis_W),
                       frame.header.now_ns - m_last_ns < kTwoTicks_ns);
        if ((frame.header.guards & core::guard_bits::kPassivity) != 0)
            ++m_record.damped;
    }
    m_last_ns = frame.header.now_ns;
    return true;
}

} // namespace chiron::haptics
