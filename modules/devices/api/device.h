// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/device_sample.h"
#include "core/result.h"
#include "core/visible_cues.h"
#include "devices/api/device_descriptor.h"
#include "devices/api/kinematics.h"
#include "realtime/haptic_tick.h"

namespace chiron::devices {

/// What the supervisor lets through to one tool. Only the loop makes it, from the supervisor's answer.
struct ForceCommand {
    core::Wrench wrench_D;     ///< on the tool, in D, about the tip; all of it
    core::Wrench compensation_D; ///< what of it overcomes the mechanism's own friction: no tissue force, left out of what is measured
    core::DisplayPose display; ///< fingertip platforms
    bool enabled = false;      ///< false: motors off, the wrench is zero
};

/// One tool of one device. Life: constructed -> open() -> ticks -> close(). read/command run in the haptic thread and
/// never block: a driver with a blocking transport talks to its own I/O thread through LatestValue.
class IDevice {
public:
    IDevice() = default;
    IDevice(const IDevice&) = delete;
    IDevice& operator=(const IDevice&) = delete;
    virtual ~IDevice() = default;

    virtual const DeviceDescriptor& descriptor() const noexcept = 0;
    virtual const IToolKinematics& kinematics() const noexcept = 0;
    virtual core::Result<void> open() = 0; ///< may block and allocate; not in the tick
    virtual void close() noexcept = 0;     ///< zero force first

    /// Newest packet; the same one again if none came. In-process devices return the sample of this tick.
    virtual core::DeviceSample read(const realtime::HapticTick& now) noexcept = 0;
    /// Hands over the force. In-process devices step their plant by one tick here.
    virtual void command(const realtime::HapticTick& now, const ForceCommand& command) noexcept = 0;
    /// What is on the screen at this tick: scripted operators look at it, hardware ignores it.
    virtual void show(const realtime::HapticTick&, const core::VisibleCues&) noexcept {}
    /// Whether what moves the device has come to its end, which ends the session: a recording does, a hand does not. Any thread.
    virtual bool finished() const noexcept { return false; }
};

} // namespace chiron::devices
