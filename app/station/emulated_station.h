// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/station/fault_plan.h"
#include "app/station/faulty_line.h"
#include "core/result.h"
#include "devices/driver.h"
#include "realtime/haptic_tick.h"
#include "station/protocol/station_device.h"
#include "station/stream/frame_stream.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>

namespace chiron::station {

/// What a station has done, by its own clock.
struct StationTotals {
    std::uint64_t ticks = 0;
    std::uint64_t applied = 0;                              ///< valid outputs
    std::array<std::int32_t, STATION_AXES> largestEffort{}; ///< uN or uN·m, magnitudes that the motors got
    double largestDisplay_N = 0.0;
    std::uint64_t lastForce_us = 0;  ///< when a motor or the platform last gave something; 0: never
    std::uint64_t lastOutput_us = 0; ///< when the last valid output came; 0: never
    station_counters counters{};
};

/// A haptic station as a program: a mechanism of the catalogue's simulated driver in a scripted hand, the
/// device's side of the station protocol, and a fault on demand. It has no clock and no line of its own: who
/// owns it says when a millisecond has passed and carries the frames.
/// Thread: one.
class EmulatedStation {
public:
    struct Configuration {
        std::string mechanism; ///< kinematics id
        devices::ToolShape shape = devices::ToolShape::point;
        std::unique_ptr<mechanisms::HandStrategy> strategy; ///< what the hand that holds it does
        mechanisms::HandParameters hand;
        core::Vec3 endoscopeStart_D{0.0, -0.069, 0.0}; ///< tip of an endoscope at the start, m
        std::uint64_t seed = 1;                        ///< of the hand's tremor and of the fault
        FaultPlan fault;
        bool lockstep = false; ///< says that it is stepped by its host
        std::string serialNumber = "emulated-0001";
    };

    /// Errors: wrongUse for an unknown mechanism; badInput.
    static core::Result<std::unique_ptr<EmulatedStation>> create(Configuration configuration);
    ~EmulatedStation();

    /// A host has connected, or the line is gone: motors off, and any number next.
    void lineChanged();
    /// A frame has come, `into_us` after the last tick. True if it was anything but a request for a
    /// feature page, whose reply is then to be sent.
    bool receive(const FrameBytes& frame, std::uint32_t into_us);
    /// A millisecond has passed: the mechanism moves on with the efforts of the newest output, and an input
    /// frame is made.
    void tick();
    /// The next frame to be sent; false if there is none.
    bool nextToSend(FrameBytes& frame);
    /// The frame that ends the step of a stepped station: its counters, which no fault touches.
    FrameBytes endOfStep() const;

    bool frozen() const noexcept { return m_line.frozen(m_ticks.executed()); }
    bool unplugged() const noexcept { return m_line.unplugged(m_ticks.executed()); }
    /// A block of a serial line was no frame.
    void brokenBlock() { station_device_broken_block(&m_device); }
    StationTotals totals() const;
    const devices::DeviceDescriptor& descriptor() const noexcept { return m_tool.device->descriptor(); }

    /// What the screen shows, for scripted hands that look at it. There is no such line to a real station.
    void show(const core::VisibleCues& cues) noexcept { m_cues = cues; }

private:
    EmulatedStation(Configuration configuration, devices::DriverTool tool);
    std::uint32_t now_us(std::uint32_t into_us) const noexcept {
        return static_cast<std::uint32_t>(1000 * m_ticks.executed() + into_us);
    }
    void drive();
    void makeInput(const core::DeviceSample& sample);

    Configuration m_configuration;
    devices::DriverTool m_tool;
    std::unique_ptr<station_device_config> m_config; ///< the device keeps its address
    station_device m_device{};
    FaultyLine m_line;
    realtime::TickSource m_ticks;
    core::VisibleCues m_cues;
    StationTotals m_totals;
    double m_drift_counts = 0.0;
};

} // namespace chiron::station
