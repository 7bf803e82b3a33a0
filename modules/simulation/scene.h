// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/command.h"
#include "core/contact_bits.h"
#include "core/session_state.h"
#include "core/quantity.h"
#include "core/tool_state.h"
#include "core/visible_cues.h"
#include "realtime/haptic_tick.h"
#include "simulation/attributes/damping_budget.h"
#include "simulation/slow_model.h"

#include <cstdint>

namespace chiron::simulation {

/// What the loop tells the scene at each tick beside the tools.
struct SceneInput {
    core::ToolStates tools;
    bool started = false;    ///< the start command was given
    bool paused = false;     ///< trial clocks stand still
    bool forceReady = false; ///< the supervisor's gain is full (on an input-only device: always true)
    bool mark = false;       ///< the mark command arrived this tick (button marks come with the tools)
    int reports = 0;         ///< report commands of this tick (button reports come with the tools)
    std::array<std::uint16_t, core::kMaxCommandsPerTick> report{}; ///< their words (core/palpation_cues.h)
    bool present = false;        ///< the command to present a stimulus arrived this tick
    std::uint16_t presented = 0; ///< its word (core/presentation_word.h)
    bool answer = false;         ///< a participant's answer arrived this tick
    std::uint16_t answered = 0;  ///< the outcome it names
    core::ForceState force = core::ForceState::off; ///< of the previous tick, for the cues
    SlowUpdate slow = SlowUpdate::asDue; ///< when the slow model's answer takes effect
    /// What may damp each tool altogether, in W: b_max of its device over the workspace's scale. No law goes beyond it.
    std::array<double, core::kMaxTools> dampingBudget_Ns_per_m{kUnboundedDamping, kUnboundedDamping, kUnboundedDamping, kUnboundedDamping};
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
    /// What of each tool's damping budget its laws use in this tick; the passivity controller may inject the rest.
    std::array<double, core::kMaxTools> damping_Ns_per_m{};
    /// A bound of ‖f‖ of each tool that follows from its stored energy alone, N, in W; 0: none is known. Where a law answers places of the same
    /// energy with different forces (a dimple's slope, friction), a cap on ‖f‖ would make energy: the cap then acts on this, or on ‖f‖ where that is more.
    std::array<double, core::kMaxTools> load_N{};
    /// Surface point to draw the tool at (pseudo-haptics). Written out, because an Eigen vector is not zeroed
    /// by {}.
    std::array<core::Vec3, core::kMaxTools> p_WProxy{core::Vec3::Zero(), core::Vec3::Zero(),
                                                     core::Vec3::Zero(), core::Vec3::Zero()};
    core::VisibleCues cues;
    /// Which tools touch one and the same body: tools with the same number (0..kMaxTools-1) share one book of energy, because
    /// they can pass energy to each other through it. All 0 where a scene does not say.
    std::array<std::uint8_t, core::kMaxTools> body{};
    /// `storedEnergy_J` and `contactStiffness_N_per_m` by body, valid with `energyByBody`; else all of it is body 0's.
    bool energyByBody = false;
    std::array<double, core::kMaxTools> bodyEnergy_J{};
    std::array<double, core::kMaxTools> bodyStiffness_N_per_m{};
    std::array<std::uint8_t, core::kMaxTools> contact{};   ///< core::contact_bits of each tool; recorded
    std::array<double, core::kMaxQuantities> quantities{}; ///< recorded; the kind of exercise names them in this order
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
    /// What has to be stepped beside the loop, at 30–100 Hz, on a thread of its own when the session runs in real time
    /// (two rates, P2); null where there is no such model. Owned by the scene; thread: set-up.
    virtual ISlowModel* slowModel() noexcept { return nullptr; }
};

} // namespace chiron::simulation
