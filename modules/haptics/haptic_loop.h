// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "core/result.h"
#include "devices/api/device.h"
#include "devices/api/workspace_map.h"
#include "haptics/display_state.h"
#include "haptics/friction_compensation.h"
#include "haptics/loop_statistics.h"
#include "haptics/safety_supervisor.h"
#include "haptics/scene_exchange.h"
#include "haptics/tick_inputs.h"
#include "realtime/latest_value.h"
#include "realtime/tick_task.h"
#include "simulation/scene.h"
#include "simulation/velocity_estimator.h"

#include <array>
#include <memory>
#include <span>

namespace chiron::haptics {

/// One tool of a loop: its device and the position of its workspace in W.
struct LoopTool {
    devices::IDevice& device;
    devices::WorkspaceMapping mapping;
};

/// The parts of a loop. All of them must outlive it, except where stated.
struct HapticLoopParts {
    std::span<const LoopTool> tools; ///< 1..kMaxTools; read during create() only
    ITickInputs& inputs;             ///< LiveInputs or RecordedInputs
    SafetySupervisor& supervisor;    ///< configured by create(), for these tools
    SafetySettings safety;
    SceneExchange& scenes;      ///< the scene offered before create() is the first one
    core::IFrameSink& recorder; ///< receives the frame of every executed tick
};

/// The 1 kHz loop of one session: sample -> scene -> supervisor -> device; each tick is recorded and shown.
/// It is a TickTask: runners and replays call tick(). The same code runs live and in replay; only ITickInputs
/// differs (architecture.md, Determinism). The destructor gives the scene back through the exchange.
/// Thread: create() and destruction on any thread while no tick runs; tick() and timing() on the haptic
/// thread; display() and statisticsTap() are read by one other thread each.
class HapticLoop {
public:
    /// Builds a loop and configures its supervisor.
    /// Errors: badInput for a wrong number of tools, a missing first scene, or settings that the supervisor
    /// refuses.
    static core::Result<std::unique_ptr<HapticLoop>> create(const HapticLoopParts& parts);
    HapticLoop(const HapticLoop&) = delete;
    HapticLoop& operator=(const HapticLoop&) = delete;
    ~HapticLoop();

    /// Runs one tick. Returns false if the session is over, that is after the end command or when the scene
    /// has finished; in this same tick the devices were commanded zero force.
    bool tick(const realtime::HapticTick& now) noexcept;

    /// Called by PeriodicRunner after each tick.
    void timing(const realtime::TickTiming& timing) noexcept;

    /// Returns the display state of the last tick.
    /// Thread: haptic (for a session's own taps), or any while no tick runs.
    const DisplayState& shown() const noexcept { return m_shown; }
    realtime::LatestValue<DisplayState>& display() noexcept { return m_displayTap; }
    /// Holds a snapshot every 256 ticks while the loop runs.
    realtime::LatestValue<LoopStatistics>& statisticsTap() noexcept { return m_statisticsTap; }
    const LoopStatistics& statistics() const noexcept { return m_statistics; } ///< only while no tick runs
    /// Energy that the passivity controller has withheld from people so far, J in W; only while no tick runs.
    double passivityKept_J() const noexcept { return m_safe.energyKept_J; }
    double passivityWithheld_J() const noexcept { return m_safe.energyWithheld_J; } ///< likewise, unsigned
    std::uint64_t droppedFrames() const noexcept { return m_droppedFrames; } ///< only while no tick runs

private:
    explicit HapticLoop(const HapticLoopParts& parts);

    void takeOfferedScene() noexcept;
    void applyPendingCommands() noexcept;
    void readDevices(const realtime::HapticTick& now) noexcept;
    void admitTool(const realtime::HapticTick& now, std::size_t i) noexcept;
    void respond(const realtime::HapticTick& now) noexcept;
    void limit(const realtime::HapticTick& now) noexcept;
    void commandDevices(const realtime::HapticTick& now) noexcept;
    void showCues(const realtime::HapticTick& now) noexcept;
    void fillFrame(const realtime::HapticTick& now) noexcept;
    void fillDisplay(const realtime::HapticTick& now) noexcept;
    ToolDisplay displayOf(std::size_t i) const noexcept;

    /// State of one tool that the loop keeps from tick to tick.
    struct Tool {
        devices::WorkspaceMap map;
        simulation::VelocityEstimator velocity;
        FrictionCompensation friction;
        core::Wrench compensation_W; ///< of the last good sample
        bool hasPose = false;        ///< a good packet has arrived
        bool refused = false;        ///< the current packet was refused
    };

    std::size_t m_count;
    std::array<devices::IDevice*, core::kMaxTools> m_devices{};
    std::array<Tool, core::kMaxTools> m_tools;
    ITickInputs& m_inputs;
    SafetySupervisor& m_supervisor;
    SceneExchange& m_scenes;
    core::IFrameSink& m_recorder;
    simulation::IScene* m_scene;

    // State of the current tick.
    TickInputs m_in;
    core::ToolStates m_states;
    simulation::SceneOutput m_out;
    SafetyOutput m_safe;
    core::HapticFrame m_frame;
    DisplayState m_shown;
    bool m_swapped = false;
    bool m_mark = false;
    bool m_present = false; ///< study commands of this tick
    bool m_answer = false;
    std::uint16_t m_presented = 0;
    std::uint16_t m_answered = 0;
    std::size_t m_reports = 0; ///< report commands of this tick
    std::array<std::uint16_t, core::kMaxCommandsPerTick> m_report{};

    // State that commands have set.
    bool m_started = false;
    bool m_pauseWanted = false;
    bool m_resuming = false; ///< resumed, but force is not back yet: the trial's clock is still stopped
    bool m_endWanted = false;
    bool m_paused = false;

    LoopStatistics m_statistics;
    std::uint64_t m_droppedFrames = 0;
    realtime::LatestValue<DisplayState> m_displayTap;
    realtime::LatestValue<LoopStatistics> m_statisticsTap;
};

} // namespace chiron::haptics
