// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exercise_cues.h"
#include "core/geometry.h"
#include "core/session_state.h"
#include "core/tool_state.h"
#include "haptics/safety_io.h"

#include <array>
#include <cstdint>
#include <type_traits>

namespace chiron::haptics {

/// One tool as a screen draws it.
/// Frame: W.
struct ToolDisplay {
    std::array<double, 3> p_WT_m{};
    std::array<double, 4> q_WT{1.0, 0.0, 0.0, 0.0}; ///< w, x, y, z
    std::array<double, 3> v_WT_m_per_s{};
    std::array<double, 3> p_WProxy_m{}; ///< where to draw the tip: at the surface while in contact
    double jaw_rad = 0.0;
    core::Array6 tissue{};               ///< computed by the scene; cues use this one
    core::Array6 commanded{};            ///< after the supervisor; zero on an input-only device
    core::Array6 measured{};             ///< valid if `measuredValid`
    std::array<double, 3> displayPose{}; ///< requested of a fingertip platform: normal force N, pitch rad,
                                         ///< roll rad
    std::array<double, 3> safeDisplay{}; ///< the same after the supervisor
    std::uint32_t buttons = 0;
    std::uint32_t age_us = 0;
    std::uint8_t contact = 0; ///< core::contact_bits of this tick
    bool measuredValid = false;
    bool rendersForce = false;
    bool enabled = false;    ///< motors on
    bool noMovement = false; ///< input-only device silent for 2 s
};

/// Everything that a screen needs from one tick, as one trivially copyable value that passes through
/// LatestValue.
struct DisplayState {
    std::uint64_t tick = 0;
    std::int64_t now_ns = 0;
    int tools = 0;
    std::array<ToolDisplay, core::kMaxTools> tool{};

    core::ForceState force = core::ForceState::off;
    ArmingWait waitsFor = ArmingWait::firstPacket; ///< the next action or event before force comes
    std::uint32_t guards = 0;                      ///< core::guard_bits of this tick
    std::uint32_t guardsSeen = 0;                  ///< guard bits of all ticks since the start of the run
    double gain = 0.0;                             ///< 0..1
    bool forceReady = false;

    std::uint16_t trial = 0;
    core::TrialPhase phase = core::TrialPhase::idle;
    std::uint32_t events = 0; ///< core::event_bits of this tick
    double timeLeft_s = 0.0;  ///< of the trial
    bool started = false;
    bool paused = false;
    bool ended = false; ///< the end command came, or the last trial is over: the loop returns
                        ///< false

    bool objectShown = false; ///< the level shows the object
    std::array<double, 3> p_WObject_m{};
    double objectRadius_m = 0.0;
    core::ExerciseCues exercise;   ///< the cues that only this exercise shows
    double energySupplied_J = 0.0; ///< see core::TickHeader
    double energyStored_J = 0.0;

    std::uint64_t lateTicks = 0;
    std::uint64_t skippedDeadlines = 0;
    std::uint64_t droppedFrames = 0; ///< the recorder had no room: the session is incomplete
};

static_assert(std::is_trivially_copyable_v<DisplayState>);

} // namespace chiron::haptics
