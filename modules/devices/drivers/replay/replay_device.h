// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device.h"
#include "devices/api/trace_point.h"
#include "devices/drivers/cartesian/cartesian_kinematics.h"

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

namespace chiron::devices {

/// Plays a trace. The trace is resampled to one sample per tick from its first row on: positions and jaw
/// linearly, the orientation by slerp, buttons held from row to row (one that is pressed and released between
/// two ticks shows for one tick), all quantised to 1 µm and 1 µrad before anything else sees it. After the
/// last row the last pose remains and finished() is true. Input-only (class "shown"): nobody feels the force
/// that it is commanded. The orientation is a rotation vector that continues without a jump (kinematics
/// "cartesian", six axes). Stepped in the tick (age 0, device time = index · 1 ms).
/// Thread: read() on the haptic thread; finished() on any; the rest not in the tick.
class ReplayDevice final : public IDevice {
public:
    static constexpr double kGrid_m = 1e-6;
    static constexpr double kGrid_rad = 1e-6;
    static constexpr double kMaximumLength_s = 4.0 * 3600.0; ///< keeps a wrong time from taking all memory

    /// Creates the device.
    /// Errors: badInput, naming the row (1-based), for: no rows; a value that is not finite; time that does
    /// not increase; a position beyond 10 m or a jaw beyond 2π; an orientation that is not a unit quaternion
    /// within 1 %, or is missing in some rows.
    static core::Result<std::unique_ptr<ReplayDevice>> create(const std::vector<TracePoint>& trace);

    bool finished() const noexcept override { return m_finished.load(std::memory_order_acquire); }
    std::size_t ticks() const noexcept { return m_samples.size(); } ///< length of the trace

    const DeviceDescriptor& descriptor() const noexcept override { return m_descriptor; }
    const IToolKinematics& kinematics() const noexcept override { return m_kinematics; }
    core::Result<void> open() override; ///< starts from the first row again
    void close() noexcept override {}
    core::DeviceSample read(const realtime::HapticTick& now) noexcept override;
    void command(const realtime::HapticTick&, const ForceCommand&) noexcept override {}

private:
    /// State of the trace at one tick.
    struct Step {
        std::array<std::int32_t, 6> counts{};
        std::int32_t jawCounts = 0;
        std::uint32_t buttons = 0;
    };
    ReplayDevice(DeviceDescriptor descriptor, const CartesianKinematics& kinematics,
                 std::vector<Step> samples);
    static std::vector<Step> resample(const std::vector<TracePoint>& trace);

    DeviceDescriptor m_descriptor;
    CartesianKinematics m_kinematics;
    std::vector<Step> m_samples; ///< never empty
    std::size_t m_next = 0;
    std::uint32_t m_packet = 0;
    std::atomic<bool> m_finished{false};
};

} // namespace chiron::devices
