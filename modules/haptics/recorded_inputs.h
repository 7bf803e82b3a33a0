// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "haptics/tick_inputs.h"

namespace chiron::haptics {

/// Inputs of a replay: the recorded commands, packets, ages and heartbeat age, one frame at a time. Call
/// `inputs.setFrame(frame); loop.tick(ticks.next(frame.header.now_ns));` for each frame in order; the loop's
/// sink then receives the re-simulated frame.
/// Thread: one.
class RecordedInputs final : public ITickInputs {
public:
    ~RecordedInputs() override;
    void setFrame(const core::HapticFrame& frame) noexcept { m_frame = frame; }
    void gather(const realtime::HapticTick& now, std::span<devices::IDevice* const> devices,
                TickInputs& inputs) noexcept override;

private:
    core::HapticFrame m_frame;
};

} // namespace chiron::haptics
