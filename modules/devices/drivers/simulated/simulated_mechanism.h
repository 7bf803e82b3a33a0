// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device.h"
#include "devices/api/driven_axes.h"
#include "devices/api/workspace_map.h"
#include "mechanisms/encoder_line.h"
#include "mechanisms/hand.h"
#include "mechanisms/jaw.h"
#include "mechanisms/plant.h"
#include "mechanisms/wrist.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace chiron::devices {

/// What every simulated mechanism states, whatever delay its plant is given.
inline constexpr std::uint32_t kOldestSample_us = 1000u * mechanisms::kMostSampleDelay_ticks;

/// The hand that holds a simulated mechanism, whichever mechanism it is.
struct SimulatedHandSettings {
    mechanisms::HandParameters hand;
    WorkspaceMapping mapping;      ///< converts the cues to D and `measured` to W
    std::uint64_t seed = 1;        ///< seed of the hand's tremor
    double toolMass_kg = 0.0;      ///< mass that the hand moves, for its tremor
    double toolInertia_kgm2 = 0.0; ///< inertia that the wrist turns
    /// Jaw of a grasper; empty: no jaw, and its counts stay 0.
    std::optional<mechanisms::JawParameters> jaw = std::nullopt;
    int jawDelay_ticks = 0; ///< delay of its potentiometer, like the encoders'
};

/// A simulated mechanism with a scripted hand on it, as one in-process tool. The tick steps plant, hand and
/// decision model, which never read a clock, so real-time runs and runs faster than real time give the same
/// samples bit for bit. Derived classes add what differs between mechanisms: plant, kinematics and
/// descriptor.
///
/// Tick n: show() gives the decision model what is on the screen; read() returns the counts that the plant
/// reached at the end of tick n − 1 (deviceTime = n·1000 µs, packet = n, age 0); command() takes the wrench,
/// runs the decision model and integrates the plant to n + 1. The wrench goes through kinematics().efforts(),
/// motors saturate, and `measured` is what they really gave (on the tool, in W). A tool that turns is also
/// held by a wrist; a grasper's jaw follows the hand's intention (Jaw), including the reaction delay.
/// Thread: haptic; allocates nothing after construction.
class SimulatedMechanism : public IDevice, public IDrivenAxes {
public:
    ~SimulatedMechanism() override;

    const DeviceDescriptor& descriptor() const noexcept final { return m_descriptor; }
    /// Returns everything that the device simulates to its start, sensors and tremor included: a device that
    /// is opened again gives the same samples to the same intentions. The strategy continues from where it
    /// is.
    core::Result<void> open() final;
    void close() noexcept final;
    core::DeviceSample read(const realtime::HapticTick& now) noexcept final;
    void command(const realtime::HapticTick& now, const ForceCommand& command) noexcept final;
    void show(const realtime::HapticTick& now, const core::VisibleCues& cues) noexcept final;
    void drive(const AxisValues& efforts, const core::DisplayPose& display_D, bool enabled) noexcept final;

    const mechanisms::Hand& hand() const noexcept { return m_hand; } ///< true state, for tests
    const mechanisms::Wrist& wrist() const noexcept { return m_wrist; }
    std::int32_t jawCounts() const noexcept { return m_jaw ? m_jaw->counts() : 0; }
    double jaw_rad() const noexcept { return m_jaw ? m_jaw->angle_rad() : 0.0; } ///< true angle, for tests

protected:
    SimulatedMechanism(const SimulatedHandSettings& settings, DeviceDescriptor descriptor,
                       std::unique_ptr<mechanisms::HandStrategy> strategy);
    virtual mechanisms::Plant& movedPlant() noexcept = 0;
    virtual void resetPlant() noexcept = 0; ///< at rest at the start, motors off
    // Additions of a mechanism beyond its plant (a fingertip platform): its channels, its effect on the hand,
    // its own tick.
    virtual void addToSample(core::DeviceSample&) const noexcept {}
    virtual void addToPerception(mechanisms::HandPerception&) const noexcept {}
    virtual void stepDisplay(const ForceCommand&) noexcept {} ///< after the plant's steps

private:
    void step(const mechanisms::AxisEfforts& efforts, const ForceCommand& command) noexcept;
    mechanisms::HandPerception perceive() const noexcept;
    core::Wrench gripOnTool(const mechanisms::ToolMotion& tool) const noexcept;

    DeviceDescriptor m_descriptor;
    WorkspaceMap m_map;
    mechanisms::Hand m_hand;
    mechanisms::Wrist m_wrist;
    std::optional<mechanisms::Jaw> m_jaw;
    std::unique_ptr<mechanisms::HandStrategy> m_strategy;
    core::VisibleCues m_cues;
    core::DeviceSample m_sample;
    core::Wrench m_onHand_D;       ///< mean over the last tick
    core::Wrench m_compensation_D; ///< of the last command
    bool m_turns = false;
    std::uint64_t m_ticks = 0;
};

} // namespace chiron::devices
