// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tool_state.h"
#include "haptics/passivity_observer.h"
#include "haptics/safety_settings.h"
#include "haptics/safety_tool.h"

#include <array>

namespace chiron::haptics {

/// State of one touched body at one tick, as the passivity stage sees it.
struct PassivityContact {
    double stored_J = 0.0; ///< U as the scene reports it, at full gain and without caps; finite, >= 0
    double stiffness_N_per_m = 0.0;                 ///< largest active contact stiffness; finite, >= 0
    double gain = 0.0;                              ///< gain of this tick
    double gainBefore = 0.0;                        ///< gain of the tick before
    bool touching = false;                          ///< any tool touches the body
    bool givesWay = false;                          ///< the scene states energy per body: render softer
                                                    ///< instead of damping
    std::array<bool, core::kMaxTools> members{};    ///< the tools at this body
    std::array<double, core::kMaxTools> capRatio{}; ///< of the requested wrench at full gain; see capRatio()
    double capKnee = 0.0;                           ///< SafetySettings::capKnee
    std::array<double, core::kMaxTools> share{};    ///< of U; the members' shares add up to 1 (by ‖f‖²)
    /// Damping that the scene's laws already take from the tool's budget, in W.
    std::array<double, core::kMaxTools> damping_Ns_per_m{};
};

/// All bodies of one tick. `bodyOf[i]` is the body of tool i, 0..kMaxTools-1; a body without members has no
/// energy balance.
struct PassivityBodies {
    std::array<std::uint8_t, core::kMaxTools> bodyOf{};
    std::array<PassivityContact, core::kMaxTools> contacts{};
};

/// Time-domain passivity controller (models.md §5; Hannaford & Ryu 2002). It keeps an observer for each body
/// and limits the energy that comes back, by damping or by rendering the body softer.
///
/// Stored energy: U is the energy of the force *as rendered*. With gain g and the cap ratio ρ of the
/// requested force, a linear spring holds g U s(2-s), s = min(1, ρ/g), the potential of a spring whose force
/// stops rising at the cap. A capped spring, which is passive, is therefore left alone. Of a spring that
/// stiffens the same formula gives less than it holds (at most 12 % less up to twice the cap), so it is left
/// alone, too; what comes back is at most what was put in and 1 mJ for any U ≥ 0. With a knee in the
/// cap (bentToCap) the energy is g U bentEnergy(g/ρ). A force field that is capped along its own direction
/// remains a potential only if the cap depends on U alone; a scene whose force differs at the same U states
/// this (load_N). A change of gain is credited with the energy that it puts in or takes out at this pose:
/// ½Δk x² for the spring.
///
/// Damping: it acts during the coming tick, so the excess is estimated for the end of that tick:
/// U - W + ½ g k (‖v‖T)², where the last term is the energy that a sampled spring leaks in one tick. When the
/// excess passes 1 mJ (at the device: energy in W over workspace scale), f = -α u and τ = -α r² w are added.
/// u and w are v and ω through a first-order low-pass (kFilter_s): an estimate from a few encoder counts
/// jumps every few ticks, and damping computed from it shakes a mechanism as much as it calms it.
///   α = excess / (T max(Σ(u·v + r² w·ω), Σ(u² + r² w²)))
/// removes the excess in this tick once the filter has caught up with v. α is at most g·(b_max - b), where b
/// is the damping of the scene's laws: everything that damps shares one budget (models.md §8). A force that
/// pushes along the motion is at most cancelled, never reversed, because contact does not pull. r = torque
/// cap / force cap.
///
/// Balances: each body has one energy balance (P2, "Control Algorithm for Multiple Instruments"). Tools at
/// one body can pass energy to each other through it and share its balance; tools at different bodies cannot
/// borrow from each other. When a tool changes its body (two objects become one, or one becomes two), energy
/// moves with it: the whole balance if no tool stays behind; otherwise the energy that the new body holds, as
/// far as the old balance has it.
///
/// Softening: if a scene states energy per body (`givesWay`), the response to an excess is not damping but a
/// softer body. The wrenches of its tools are rendered at a share c, f = c f_scene, which holds
/// E = c g U s(2-s), s = min(1, ρ/(c g)). Damping needs a velocity, which comes late: with the delay of a
/// device it drives two hands on one tube rather than calming them (tests/unit/haptics/test_two_hands).
/// Lowering c while the body is stretched destroys energy that nobody receives, which reduces the excess E -
/// W. c therefore falls until the loop makes no more energy than the balance allows, which is at the
/// stiffness that the device's delay permits. c falls only under load (kLoaded_J), where this has an effect,
/// and more slowly the smaller that effect is. c rises again only on energy that people have put in beyond
/// what is held, and that energy then counts as held. It rises by at most kRise per tick, half as fast after
/// each renewed fall, and returns to 1 at once when the body is released.
///
/// Limits of the balance: a deficit is forgiven at kForgiven_W, up to kForgiven_J per contact; otherwise the
/// leak of a trembling hand would soften every long hold. Energy put in beyond what is held counts up to
/// kSurplus_J, since the rest has become heat. A contact therefore never holds more than the plain work put
/// in (work_J()), the 1 mJ that is allowed, kForgiven_J, and the energy made while c falls. The balance is
/// kept twice, with the force of the last tick and with that of as many ticks before as the samples of the
/// tool's device may be old (passivity_observer.h), and the worse one counts; the late one is forgiven at
/// kForgivenLate_W without a limit.
///
/// Thread: haptic.
class PassivityController {
public:
    /// A cut-off of 80 Hz passes a sixth of a vibration at 450 Hz and lags by 13° on the hardest wall
    /// (18 Hz).
    static constexpr double kFilter_s = 0.002;
    /// Assumption: a tremor of 0.1 mm on 500 N/m at 3 ms of delay makes 0.2 mW.
    static constexpr double kForgiven_W = 0.001;
    /// Assumption: an ovary of 10 g lifted by 0.2 m. While c < 1 the surplus is limited to what is allowed
    /// instead.
    static constexpr double kSurplus_J = 0.020;
    static constexpr double kForgiven_J = 0.001; ///< assumption: per contact, as much as is allowed anyway
    /// Assumption: a tremor of 0.1 mm on 200 N/m at 3 ms of delay makes 0.1 mW.
    static constexpr double kForgivenLate_W = 1e-4;
    static constexpr double kLoaded_J = 1e-5; ///< assumption: 45 mN on 100 N/m
    static constexpr double kLeastShare = 0.02;
    static constexpr double kFall = 0.01; ///< largest fall of c per tick: 10 mN per newton
    static constexpr double kRise = 5e-5; ///< assumption: largest rise of c per tick: 0 to 1 in 20 s, not
                                          ///< felt as a step

    using Limits = std::array<SafetyToolLimits, core::kMaxTools>;
    using Wrenches = std::array<core::Wrench, core::kMaxTools>;

    void reset(const SafetySettings& settings) noexcept;

    /// Adds the last tick's work to the balances. If too much energy could come back, it adds damping to
    /// `wrenches` (already multiplied by the gain) or scales them down, and returns true. `count` is the
    /// number of tools.
    bool apply(const Limits& limits, int count, const core::ToolStates& states, const PassivityBodies& bodies,
               Wrenches& wrenches) noexcept;

    /// Remembers the wrenches that are really rendered, after caps and slew.
    void hold(const core::ToolStates& states, const core::ToolWrenches& commanded) noexcept;

    /// U - W at the last apply(), in W.
    double excess_J(std::size_t body = 0) const noexcept { return m_accounts[body].excess_J; }
    /// Supplied energy W with its credits, summed over the touched bodies; J in W.
    double supplied_J() const noexcept;
    /// Work that people put in, -Σ f·Δx of each contact, without credits or settlements, summed alike.
    double work_J() const noexcept;
    double stored_J() const noexcept; ///< U as rendered, summed alike
    /// Energy withheld from people since reset(): the work of the requested wrenches minus the work of those
    /// that were let through, computed with the tools' estimated velocities; J in W.
    double kept_J() const noexcept { return m_kept_J; }
    /// The same without what people were spared: the sum of its positive parts. What a softer body, or
    /// damping, spared them (they push against less) is withheld_J() − kept_J().
    double withheld_J() const noexcept { return m_withheld_J; }

    /// Returns g U s(2-s), or its form with a knee, summed over the tools' shares.
    static double renderedEnergy_J(const PassivityContact& contact, double gain, int count) noexcept;

private:
    /// The energy balance of one body.
    struct Account {
        PassivityObserver observer;
        double share = 1.0;      ///< c
        double rise = 1.0;       ///< share of kRise: halved by each fall after a rise
        double stored_J = 0.0;   ///< as rendered
        double excess_J = 0.0;   ///< stored - supplied
        double forgiven_J = 0.0; ///< in this contact
        bool risen = false;      ///< c has risen since it last fell
        bool open = false;       ///< the body is touched

        void close() noexcept;
        void settle(double surplus_J) noexcept; ///< forgives a small deficit, limits the surplus
        void fall(double by) noexcept;
        void recover(double most) noexcept;
    };

    /// Filtered velocities u and w of one tool.
    struct Smoothed {
        core::Vec3 v = core::Vec3::Zero();
        core::Vec3 w = core::Vec3::Zero();
    };
    void smooth(const core::ToolStates& states) noexcept;
    void regroup(int count, const PassivityBodies& bodies) noexcept;
    bool applyTo(Account& account, const Limits& limits, int count, const core::ToolStates& states,
                 const PassivityContact& contact, Wrenches& wrenches) noexcept;
    bool giveWay(Account& account, int count, const PassivityContact& contact,
                 Wrenches& wrenches) const noexcept;
    bool inject(double excess_J, const Limits& limits, int count, const core::ToolStates& states,
                const PassivityContact& contact, Wrenches& wrenches) const noexcept;

    SafetySettings m_settings;
    std::array<Account, core::kMaxTools> m_accounts{};
    std::array<std::uint8_t, core::kMaxTools> m_bodyOf{};
    std::array<bool, core::kMaxTools> m_used{}; ///< bodies with members
    std::array<Smoothed, core::kMaxTools> m_smoothed{};
    double m_kept_J = 0.0;
    double m_withheld_J = 0.0;
};

} // namespace chiron::haptics
