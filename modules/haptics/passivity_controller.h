// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"
#include "haptics/passivity_observer.h"
#include "haptics/safety_settings.h"
#include "haptics/safety_tool.h"

#include <array>

namespace chiron::haptics {

/// What one body that is touched looks like to the passivity stage at one tick.
struct PassivityContact {
    double stored_J = 0.0; ///< U as the scene reports it, at full gain and without caps; finite, >= 0
    double stiffness_N_per_m = 0.0;                 ///< largest active contact stiffness; finite, >= 0
    double gain = 0.0;                              ///< of this tick
    double gainBefore = 0.0;                        ///< of the tick before
    bool touching = false;                          ///< any tool
    bool givesWay = false;                          ///< the scene keeps books by body: rendered softer, not damped
    std::array<bool, core::kMaxTools> members{};    ///< the tools at this body
    std::array<double, core::kMaxTools> capRatio{}; ///< of the requested wrench at full gain; see capRatio()
    double capKnee = 0.0;                           ///< SafetySettings::capKnee
    std::array<double, core::kMaxTools> share{};    ///< of U, summing to 1 over the members (by ‖f‖²)
    std::array<double, core::kMaxTools> damping_Ns_per_m{}; ///< that the scene's laws use of the tool's budget already, in W
};

/// All bodies of one tick: `bodyOf[i]` is the body of tool i, 0..kMaxTools-1; a body without members has no book.
struct PassivityBodies {
    std::array<std::uint8_t, core::kMaxTools> bodyOf{};
    std::array<PassivityContact, core::kMaxTools> contacts{};
};

/// Time-domain passivity controller (models.md §5; Hannaford & Ryu 2002): keeps the observer and injects
/// damping.
///
/// U is taken of the force *as rendered*: with gain g and the cap ratio ρ of the requested force a linear
/// spring holds g U s(2-s), s = min(1, ρ/g) (potential of a spring whose force stops rising at the cap), so
/// that a capped spring, which is passive, is left alone; with a knee in the cap (bentToCap) it is g U bentEnergy(g/ρ). Capped along its own
/// direction a force field stays a potential only where the cap acts by U alone: a scene whose force differs at the same U says so (load_N). A change of gain is credited with the energy it
/// puts in or takes out at this place: ½Δk x² for the spring.
///
/// Damping acts during the coming tick, so the excess is taken as it will be at its end: U - W + ½ g k
/// (‖v‖T)², the energy that a sampled spring leaks in one tick. When it passes 1 mJ (of the device: W-energy
/// over workspace scale) f = -α u and τ = -α r² w are added, where u and w are v and ω through a low-pass of first order
/// (kFilter_s): the estimate of a few encoder counts jumps every few ticks, and damping made of it shakes a mechanism as
/// much as it calms it. α = excess / (T max(Σ(u·v + r² w·ω), Σ(u² + r² w²))), which takes the excess in this tick where v has
/// caught up; at most g·(b_max - b), b what the scene's laws damp already: one budget for everything that damps (models.md §8). A
/// force that pushes along the motion is at most cancelled, never reversed: contact does not pull. r = torque cap / force cap.
///
/// One book a body (P2, "Control Algorithm for Multiple Instruments"): tools at one body can pass energy to each other
/// through it and share its book; tools at different bodies cannot borrow from each other. When a tool changes its body
/// (two things become one, or one two), the book goes along: the whole of it when no tool stays behind; else what the new
/// body holds, as far as the old book has it.
///
/// Where a scene tells energy by body (`givesWay`), the answer to an excess is not damping but a softer body: its tools' wrenches
/// are rendered at a share c, f = c f_scene, which holds E = c g U s(2-s), s = min(1, ρ/(c g)). Damping needs a velocity, which
/// comes late: with the delay of a device two hands on one tube are driven by it rather than calmed
/// (tests/unit/haptics/test_two_hands). Lowering c at a stretch destroys energy that nobody gets, which pays the book, E - W: so c
/// falls until what the loop makes is what the book allows, which is at the stiffness that the device's delay carries. It falls only
/// under load (kLoaded_J), where that pays, and the slower the less it pays. It rises again only on energy that people have put
/// in beyond what is held and that is then booked as held, kRise at most, half as fast after each time that it had to fall again,
/// and at once when the body is let go of. Debts are forgiven at kForgiven_W up to kForgiven_J in a contact, or a trembling hand's
/// leak would soften every long hold; what was put in counts for kSurplus_J beyond what is held at most, since the rest has become
/// heat. So a contact never holds more than the plain work put in (work_J()), 1 mJ that is allowed, kForgiven_J, and what is made
/// while c falls. Both are kept twice, with the force of the last tick and with that of kLate_ticks before (passivity_observer.h),
/// and the worse book counts; the late one is forgiven kForgivenLate_W, without end. Thread: haptic.
class PassivityController {
public:
    static constexpr double kFilter_s = 0.002; ///< 80 Hz: a sixth of what shakes at 450 Hz, and 13° late on the hardest wall (18 Hz)
    static constexpr double kForgiven_W = 0.001; ///< assumption: a tremor of 0.1 mm on 500 N/m at 3 ms of delay makes 0.2 mW
    static constexpr double kSurplus_J = 0.020;  ///< assumption: an ovary of 10 g lifted by 0.2 m; only what is allowed while c < 1
    static constexpr double kForgiven_J = 0.001; ///< assumption: in one contact, as much as is allowed anyhow
    static constexpr double kForgivenLate_W = 1e-4; ///< assumption: a tremor of 0.1 mm on 200 N/m at 3 ms of delay makes 0.1 mW
    static constexpr double kLoaded_J = 1e-5;    ///< assumption: 45 mN on 100 N/m
    static constexpr double kLeastShare = 0.02;
    static constexpr double kFall = 0.01;  ///< of c in a tick, at most: 10 mN on each newton
    static constexpr double kRise = 5e-5;  ///< assumption: of c in a tick, at most: all of it in 20 s, not felt as a step

    using Limits = std::array<SafetyToolLimits, core::kMaxTools>;
    using Wrenches = std::array<core::Wrench, core::kMaxTools>;

    void reset(const SafetySettings& settings) noexcept;

    /// Books the last tick's work and, when too much could come back, adds damping to `wrenches` (already
    /// multiplied by the gain); true if it did. `count` tools.
    bool apply(const Limits& limits, int count, const core::ToolStates& states, const PassivityBodies& bodies,
               Wrenches& wrenches) noexcept;

    /// Books what is really shown, after caps and slew.
    void hold(const core::ToolStates& states, const core::ToolWrenches& commanded) noexcept;

    double excess_J(std::size_t body = 0) const noexcept { return m_accounts[body].excess_J; } ///< U - W at the last apply(), in W
    double supplied_J() const noexcept; ///< the book W, with its credits, summed over the bodies that are touched; J in W
    double work_J() const noexcept;     ///< what people put in, -Σ f·Δx of each contact, untouched, summed alike
    double stored_J() const noexcept;   ///< U as rendered, summed alike
    /// What it has kept from people since reset(): the work of the wrenches that were asked for less that of those it let through, by the tools'
    /// estimated velocities; J in W.
    double kept_J() const noexcept { return m_kept_J; }

    /// g U s(2-s) summed over the tools' shares.
    static double renderedEnergy_J(const PassivityContact& contact, double gain, int count) noexcept;

private:
    /// The book of one body.
    struct Account {
        PassivityObserver observer;
        double share = 1.0;      ///< c
        double rise = 1.0;       ///< of kRise: halved by each fall after a rise
        double stored_J = 0.0;   ///< as rendered
        double excess_J = 0.0;   ///< stored - supplied
        double forgiven_J = 0.0; ///< in this contact
        bool risen = false;      ///< since c last fell
        bool open = false;       ///< touched

        void close() noexcept;
        void settle(double surplus_J) noexcept; ///< forgives a little debt, cuts credit
        void fall(double by) noexcept;
        void recover(double most) noexcept;
    };

    /// u and w of one tool.
    struct Smoothed {
        core::Vec3 v = core::Vec3::Zero();
        core::Vec3 w = core::Vec3::Zero();
    };
    void smooth(const core::ToolStates& states) noexcept;
    void regroup(int count, const PassivityBodies& bodies) noexcept;
    bool applyTo(Account& account, const Limits& limits, int count, const core::ToolStates& states,
                 const PassivityContact& contact, Wrenches& wrenches) noexcept;
    bool giveWay(Account& account, int count, const PassivityContact& contact, Wrenches& wrenches) const noexcept;
    bool inject(double excess_J, const Limits& limits, int count, const core::ToolStates& states,
                const PassivityContact& contact, Wrenches& wrenches) const noexcept;

    SafetySettings m_settings;
    std::array<Account, core::kMaxTools> m_accounts{};
    std::array<std::uint8_t, core::kMaxTools> m_bodyOf{};
    std::array<bool, core::kMaxTools> m_used{}; ///< bodies with members
    std::array<Smoothed, core::kMaxTools> m_smoothed{};
    double m_kept_J = 0.0;
};

} // namespace chiron::haptics
