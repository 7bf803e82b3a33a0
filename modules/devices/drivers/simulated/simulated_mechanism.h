// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device.h"
#include "devices/api/workspace_map.h"
#include "mechanisms/hand.h"
#include "mechanisms/jaw.h"
#include "mechanisms/plant.h"
#include "mechanisms/wrist.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace chiron::devices {

/// What a simulated mechanism is held by, whichever mechanism it is.
struct SimulatedHandSettings {
    mechanisms::HandParameters hand;
    WorkspaceMapping mapping;     ///< to turn the cues into D and `measured` into W
    std::uint64_t seed = 1;       ///< of the hand's tremor
    double toolMass_kg = 0.0;     ///< what the hand moves along, for its tremor
    double toolInertia_kgm2 = 0.0; ///< what the wrist turns along
    std::optional<mechanisms::JawParameters> jaw = std::nullopt; ///< of a grasper; nothing: no jaw, its counts stay 0
    int jawDelay_ticks = 0;        ///< of its potentiometer, as the encoders'
};

/// A simulated mechanism with a scripted hand on it, as one in-process tool: plant, hand and mind are stepped by the tick and
/// never look at a clock, so real-time and as-fast runs give the same samples bit for bit. The mechanisms differ in plant,
/// kinematics and descriptor, which their own classes add.
///
/// Tick n: show() tells the mind what is on the screen, read() returns the counts that the plant reached at the end of tick
/// n − 1 (deviceTime = n·1000 µs, packet = n, age 0), command() takes the wrench, asks the mind and integrates the plant to
/// n + 1. The wrench goes through kinematics().efforts(), motors saturate, `measured` is what they really gave (on the tool,
/// in W). A tool that turns is held by a wrist as well; a grasper's jaw follows the hand's intention (Jaw), reaction delay
/// included. Haptic thread; no allocation after construction.
class SimulatedMechanism : public IDevice {
public:
    ~SimulatedMechanism() override;

    const DeviceDescriptor& descriptor() const noexcept final { return m_descriptor; }
    core::Result<void> open() final; ///< everything from the start again
    void close() noexcept final;
    core::DeviceSample read(const realtime::HapticTick& now) noexcept final;
    void command(const realtime::HapticTick& now, const ForceCommand& command) noexcept final;
    void show(const realtime::HapticTick& now, const core::VisibleCues& cues) noexcept final;

    const mechanisms::Hand& hand() const noexcept { return m_hand; } ///< the truth, for tests
    const mechanisms::Wrist& wrist() const noexcept { return m_wrist; }
    std::int32_t jawCounts() const noexcept { return m_jaw ? m_jaw->counts() : 0; }
    double jaw_rad() const noexcept { return m_jaw ? m_jaw->angle_rad() : 0.0; } ///< the truth, for tests

protected:
    SimulatedMechanism(const SimulatedHandSettings& settings, DeviceDescriptor descriptor,
                       std::unique_ptr<mechanisms::HandStrategy> strategy);
    virtual mechanisms::Plant& movedPlant() noexcept = 0;
    virtual void resetPlant() noexcept = 0; ///< at rest at the start, motors off
    // What a mechanism has beside its plant (a fingertip platform): its channels, what it does to the hand, its own tick.
    virtual void addToSample(core::DeviceSample&) const noexcept {}
    virtual void addToPerception(mechanisms::HandPerception&) const noexcept {}
    virtual void stepDisplay(const ForceCommand&) noexcept {} ///< after the plant's steps

private:
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
    core::Wrench m_onHand_D; ///< mean over the last tick
    core::Wrench m_compensation_D; ///< of the last command
    bool m_turns = false;
    std::uint64_t m_ticks = 0;
};

} // namespace chiron::devices
