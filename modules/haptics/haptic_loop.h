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

/// One tool of a loop: its device and where its workspace lies in W.
struct LoopTool {
    devices::IDevice& device;
    devices::WorkspaceMapping mapping;
};

/// What a loop is put together from. Everything outlives the loop.
struct HapticLoopParts {
    std::span<const LoopTool> tools; ///< 1..kMaxTools; read during create() only
    ITickInputs& inputs;             ///< LiveInputs or RecordedInputs
    SafetySupervisor& supervisor;    ///< configured by create(), for these tools
    SafetySettings safety;
    SceneExchange& scenes;           ///< the scene offered before create() is the first one
    core::IFrameSink& recorder;      ///< every executed tick's frame
};

/// The 1 kHz loop of one session: sample -> scene -> supervisor -> device, recorded and shown. A TickTask: runners and
/// replays call tick(). The same code runs live and in replay; only ITickInputs differs (architecture.md, Determinism).
///
/// Thread: create() and destruction anywhere while no tick runs; tick() and timing() on the haptic thread; display() and
/// statisticsTap() are read by one other thread each. Destroying it gives its scene back through the exchange.
class HapticLoop {
public:
    /// Fails (badInput) on a wrong number of tools, a missing first scene, or what the supervisor refuses.
    static core::Result<std::unique_ptr<HapticLoop>> create(const HapticLoopParts& parts);
    HapticLoop(const HapticLoop&) = delete;
    HapticLoop& operator=(const HapticLoop&) = delete;
    ~HapticLoop();

    /// One tick. False when the session is over: after the end command, or when the scene has finished; the devices were
    /// then commanded zero force in this very tick.
    bool tick(const realtime::HapticTick& now) noexcept;

    /// From PeriodicRunner, after each tick.
    void timing(const realtime::TickTiming& timing) noexcept;

    /// What the last tick showed; haptic thread (for taps of a session's own), or while no tick runs.
    const DisplayState& shown() const noexcept { return m_shown; }
    realtime::LatestValue<DisplayState>& display() noexcept { return m_displayTap; }
    /// A snapshot every 256 ticks, while the loop runs.
    realtime::LatestValue<LoopStatistics>& statisticsTap() noexcept { return m_statisticsTap; }
    const LoopStatistics& statistics() const noexcept { return m_statistics; } ///< only while no tick runs
    /// What the passivity controller has kept from people so far, J in W; only while no tick runs.
    double passivityKept_J() const noexcept { return m_safe.energyKept_J; }
    std::uint64_t droppedFrames() const noexcept { return m_droppedFrames; }   ///< only while no tick runs

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

    /// What the loop keeps of one tool from tick to tick.
    struct Tool {
        devices::WorkspaceMap map;
        simulation::VelocityEstimator velocity;
        FrictionCompensation friction;
        core::Wrench compensation_W; ///< of the last good sample
        bool hasPose = false; ///< a good packet has come
        bool refused = false; ///< the packet that is there now was refused
    };

    std::size_t m_count;
    std::array<devices::IDevice*, core::kMaxTools> m_devices{};
    std::array<Tool, core::kMaxTools> m_tools;
    ITickInputs& m_inputs;
    SafetySupervisor& m_supervisor;
    SceneExchange& m_scenes;
    core::IFrameSink& m_recorder;
    simulation::IScene* m_scene;

    // Of the tick in hand.
    TickInputs m_in;
    core::ToolStates m_states;
    simulation::SceneOutput m_out;
    SafetyOutput m_safe;
    core::HapticFrame m_frame;
    DisplayState m_shown;
    bool m_swapped = false;
    bool m_mark = false;
    bool m_present = false; ///< commands of a study, of this tick
    bool m_answer = false;
    std::uint16_t m_presented = 0;
    std::uint16_t m_answered = 0;
    std::size_t m_reports = 0; ///< report commands of this tick
    std::array<std::uint16_t, core::kMaxCommandsPerTick> m_report{};

    // What commands left behind.
    bool m_started = false;
    bool m_pauseWanted = false;
    bool m_resuming = false; ///< resumed, and force is not back yet: the trial's clock still stands
    bool m_endWanted = false;
    bool m_paused = false;

    LoopStatistics m_statistics;
    std::uint64_t m_droppedFrames = 0;
    realtime::LatestValue<DisplayState> m_displayTap;
    realtime::LatestValue<LoopStatistics> m_statisticsTap;
};

} // namespace chiron::haptics
