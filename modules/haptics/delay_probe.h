// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "haptics/delay_estimate.h"
#include "simulation/scene.h"

#include <cstdint>

namespace chiron::haptics {

/// How a device is shaken to measure its delay: several sines at once, in bursts, along one direction. A
/// burst rises smoothly and is analysed after it has settled. Between bursts there is no force, so the
/// passivity stage sees each burst as a contact of its own, and no energy debt builds up.
struct DelayProbeSettings {
    core::Vec3 axis_W = core::Vec3::UnitZ(); ///< unit vector
    /// Amplitude of the highest sine; lower ones are weaker in proportion to their frequency; > 0, <= 1.
    double force_N = 0.5;
    int bursts = 8; ///< 3..60, 1.4 s each
};

/// The scene of a delay measurement (devices.md §6: stiffness is capped by the measured delay). It waits for
/// the start command and for full force, shakes the tool, and ends. The scene records where the tool is;
/// DelayListener records what was really commanded after the supervisor, which may be less. Together they are
/// the response of the device with the hand that holds it.
/// Thread: haptic.
class DelayProbe final : public simulation::IScene {
public:
    /// `record` must outlive the scene; it is sized here, so that no tick allocates.
    DelayProbe(const DelayProbeSettings& settings, DelayRecord& record);
    ~DelayProbe() override;
    void respond(const realtime::HapticTick& now, const simulation::SceneInput& in,
                 simulation::SceneOutput& out) noexcept override;

    static std::uint64_t ticksOf(const DelayProbeSettings& settings) noexcept; ///< from full force to the end

private:
    double force_N(int tick) const noexcept; ///< at this tick of a burst

    DelayProbeSettings m_settings;
    DelayRecord& m_record;
    core::TrialPhase m_phase = core::TrialPhase::idle;
    int m_burst = 0, m_tick = 0;
};

/// Records the commanded force of every analysed tick in the same record.
/// Thread: haptic.
class DelayListener final : public core::IFrameSink {
public:
    DelayListener(const DelayProbeSettings& settings, DelayRecord& record) noexcept
        : m_axis_W(settings.axis_W), m_record(record) {}
    ~DelayListener() override;
    bool tryPush(const core::HapticFrame& frame) noexcept override;

private:
    core::Vec3 m_axis_W;
    DelayRecord& m_record;
    std::int64_t m_last_ns = 0;
};

} // namespace chiron::haptics
