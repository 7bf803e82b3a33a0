// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/command.h"
#include "core/contact_bits.h"
#include "core/quantity.h"
#include "core/session_state.h"
#include "core/tool_state.h"
#include "core/visible_cues.h"
#include "realtime/haptic_tick.h"
#include "simulation/attributes/damping_budget.h"
#include "simulation/slow_model.h"

#include <cstdint>

namespace chiron::simulation {

/// Input of a scene for one tick: the states of the tools, the commands and the conditions of the session.
struct SceneInput {
    core::ToolStates tools;
    bool started = false;    ///< the start command was given
    bool paused = false;     ///< trial clocks stand still
    bool forceReady = false; ///< the supervisor's gain is full (on an input-only device: always true)
    bool mark = false;       ///< the mark command arrived this tick (button marks come with the tools)
    /// Number of report commands in this tick (reports by button come with the tools).
    int reports = 0;
    /// Arguments of these commands: words whose meaning the exercise defines.
    std::array<std::uint16_t, core::kMaxCommandsPerTick> report{};
    bool present = false;        ///< the command to present a stimulus arrived this tick
    std::uint16_t presented = 0; ///< argument of that command (core/presentation_word.h)
    bool answer = false;         ///< a participant's answer arrived this tick
    std::uint16_t answered = 0;  ///< argument of that command: the outcome that the participant named
    core::ForceState force = core::ForceState::off; ///< state in the previous tick, for the cues
    SlowUpdate slow = SlowUpdate::asDue;            ///< when the slow model's answer takes effect
    /// The damping that all laws together may apply to each tool, in W: b_max of its device divided by the
    /// workspace scale. No law exceeds it.
    std::array<double, core::kMaxTools> dampingBudget_Ns_per_m{kUnboundedDamping, kUnboundedDamping,
                                                               kUnboundedDamping, kUnboundedDamping};
};

/// Output of a scene for one tick.
struct SceneOutput {
    core::ToolWrenches tissue;
    std::array<core::DisplayPose, core::kMaxTools> display{};
    std::uint16_t trial = 0;
    core::TrialPhase phase = core::TrialPhase::idle;
    std::uint32_t events = 0;    ///< core::event_bits of this tick
    double storedEnergy_J = 0.0; ///< elastic energy U stored in the contacts of all tools, summed
    /// Largest active contact stiffness, for the passivity credit ½Δk x².
    double contactStiffness_N_per_m = 0.0;
    /// The part of each tool's damping budget that its laws use in this tick. The passivity controller may
    /// inject the rest.
    std::array<double, core::kMaxTools> damping_Ns_per_m{};
    /// A bound on ‖f‖ of each tool that follows from its stored energy alone, N, in W; 0: no bound is known.
    /// Where a law gives different forces at positions of the same energy (the slope of a dimple, friction),
    /// a cap on ‖f‖ would create energy. The cap then acts on this bound, or on ‖f‖ where that is larger.
    std::array<double, core::kMaxTools> load_N{};
    /// Surface point to draw the tool at (pseudo-haptics). Written out, because an Eigen vector is not zeroed
    /// by {}.
    std::array<core::Vec3, core::kMaxTools> p_WProxy{core::Vec3::Zero(), core::Vec3::Zero(),
                                                     core::Vec3::Zero(), core::Vec3::Zero()};
    core::VisibleCues cues;
    /// The body that each tool touches. Tools with the same number (0..kMaxTools-1) touch the same body and
    /// share one energy balance, because they can pass energy to each other through it. All numbers are 0
    /// where a scene does not distinguish bodies.
    std::array<std::uint8_t, core::kMaxTools> body{};
    /// If true, the two arrays below split `storedEnergy_J` and `contactStiffness_N_per_m` by body. If false,
    /// both belong to body 0.
    bool energyByBody = false;
    std::array<double, core::kMaxTools> bodyEnergy_J{};
    std::array<double, core::kMaxTools> bodyStiffness_N_per_m{};
    std::array<std::uint8_t, core::kMaxTools> contact{}; ///< core::contact_bits of each tool; recorded
    /// Recorded; each exercise names its quantities in this order.
    std::array<double, core::kMaxQuantities> quantities{};
};

/// One running exercise: geometry, attributes and task state. All trials of the session are planned from the
/// seed before the first tick, so that a run in real time and one faster than real time change trials at the
/// same tick. A scene is deterministic: its output is a pure function of the sequence of its inputs.
class IScene {
public:
    virtual ~IScene() = default;
    /// Computes the output of one tick.
    /// Thread: haptic; never allocates, locks or throws.
    virtual void respond(const realtime::HapticTick& now, const SceneInput& in,
                         SceneOutput& out) noexcept = 0;
    /// Returns the model that has to be stepped beside the loop, at 30–100 Hz (two rates, P2), or null where
    /// the scene has none. The session steps it on a thread of its own when it runs in real time. The scene
    /// owns the model.
    /// Thread: set-up.
    virtual ISlowModel* slowModel() noexcept { return nullptr; }
    /// Says whether the elastic part of its force is minus the gradient of a potential (models.md §0). No way
    /// through such a scene makes energy: friction, viscosity and damping only take some. A scene whose law
    /// has no potential says false. tests/sweep judges every level by this.
    /// Thread: set-up.
    virtual bool conservative() const noexcept { return true; }
};

} // namespace chiron::simulation
