// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/device_sample.h"
#include "core/result.h"
#include "core/visible_cues.h"
#include "devices/api/device_descriptor.h"
#include "devices/api/kinematics.h"
#include "realtime/haptic_tick.h"

namespace chiron::devices {

/// The force that the supervisor lets through to one tool. Only the loop makes it, from the supervisor's
/// output.
struct ForceCommand {
    core::Wrench wrench_D; ///< total wrench on the tool, in D, about the tip
    /// The part of it that overcomes the mechanism's own friction: not a tissue force, so it is left out of
    /// `measured`.
    core::Wrench compensation_D;
    core::DisplayPose display; ///< for fingertip platforms
    bool enabled = false;      ///< false: motors off, the wrench is zero
};

/// One tool of one device. Its life is: constructed -> open() -> ticks -> close(). A driver with a blocking
/// transport exchanges data with its own I/O thread through LatestValue.
/// Thread: read() and command() on the haptic thread, where they never block.
class IDevice {
public:
    IDevice() = default;
    IDevice(const IDevice&) = delete;
    IDevice& operator=(const IDevice&) = delete;
    virtual ~IDevice() = default;

    virtual const DeviceDescriptor& descriptor() const noexcept = 0;
    virtual const IToolKinematics& kinematics() const noexcept = 0;
    virtual core::Result<void> open() = 0; ///< may block and allocate; not in the tick
    virtual void close() noexcept = 0;     ///< commands zero force first

    /// Returns the newest packet; the same one again if none came. In-process devices return the sample of
    /// this tick.
    virtual core::DeviceSample read(const realtime::HapticTick& now) noexcept = 0;
    /// Passes the force to the device. In-process devices step their plant by one tick here.
    virtual void command(const realtime::HapticTick& now, const ForceCommand& command) noexcept = 0;
    /// Receives what the screen shows at this tick: scripted operators use it, hardware ignores it.
    virtual void show(const realtime::HapticTick&, const core::VisibleCues&) noexcept {}
    /// Returns true when the movement of the device has ended, which ends the session: a recording ends, a
    /// hand does not.
    /// Thread: any.
    virtual bool finished() const noexcept { return false; }

    /// Whether the device has no clock of its own, but moves on with each command: inside the program, or
    /// over a link. Only such a device can take part in a run faster than real time.
    virtual bool steppedByHost() const noexcept { return descriptor().inProcess; }
    /// Waits, between two ticks of a run faster than real time, until the device has taken the step of the
    /// last command. Returns false if it does not: it is gone. Not for the tick.
    virtual bool awaitStep() noexcept { return true; }
};

} // namespace chiron::devices
