// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session_state.h"
#include "core/tool_state.h"
#include "core/visible_cues.h"
#include "realtime/haptic_tick.h"

#include <cstdint>

namespace chiron::simulation {

/// What the loop tells the scene at each tick beside the tools.
struct SceneInput {
    core::ToolStates tools;
    bool started = false;    ///< the start command was given
    bool paused = false;     ///< trial clocks stand still
    bool forceReady = false; ///< the supervisor's gain is full (on an input-only device: always true)
    bool mark = false;       ///< the mark command arrived this tick (button marks come with the tools)
    core::ForceState force = core::ForceState::off; ///< of the previous tick, for the cues
};

/// What the scene answers.
struct SceneOutput {
    core::ToolWrenches tissue;
    std::array<core::DisplayPose, core::kMaxTools> display{};
    std::uint16_t trial = 0;
    core::TrialPhase phase = core::TrialPhase::idle;
    std::uint32_t events = 0;    ///< core::event_bits of this tick
    double storedEnergy_J = 0.0; ///< elastic energy U held by the contacts of tool 0..n, summed
    double contactStiffness_N_per_m =
        0.0; ///< largest active contact stiffness, for the passivity credit ½Δk x²
    /// Surface point to draw the tool at (pseudo-haptics). Written out, because an Eigen vector is not zeroed
    /// by {}.
    std::array<core::Vec3, core::kMaxTools> p_WProxy{core::Vec3::Zero(), core::Vec3::Zero(),
                                                     core::Vec3::Zero(), core::Vec3::Zero()};
    core::VisibleCues cues;
};

/// One exercise running: geometry + attributes + task state (all trials of the session, planned from the seed
/// before the first tick, so that real-time and as-fast runs change trials at the same tick). Deterministic:
/// a pure function of the sequence of inputs.
class IScene {
public:
    virtual ~IScene() = default;
    /// Thread: haptic. Never allocates, locks or throws.
    virtual void respond(const realtime::HapticTick& now, const SceneInput& in,
                         SceneOutput& out) noexcept = 0;
};

} // namespace chiron::simulation
