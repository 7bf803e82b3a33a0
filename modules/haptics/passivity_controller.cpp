// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/passivity_controller.h"

#include "core/units.h"
#include "haptics/safety_caps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::haptics {

namespace {

double lever2(const SafetyToolLimits& limits) noexcept {
    if (limits.forceCap_N <= 0.0) {
        return 0.0;
    }
    const double lever = limits.torqueCap_Nm / limits.forceCap_N;
    return lever * lever;
}

/// Adds -b v, limited so that a vector with a component along v loses at most that component.
void addDamping(core::Vec3& shown, const core::Vec3& rate, double b) noexcept {
    const double rate2 = rate.squaredNorm();
    const double power = shown.dot(rate);
    if (!(rate2 > 0.0) || !std::isfinite(rate2)) {
        return;
    }
    const double most = power > 0.0 ? power / rate2 : std::numeric_limits<double>::infinity();
    shown -= std::min(b, most) * rate;
}

} // namespace

void PassivityController::reset(const SafetySettings& settings) noexcept {
    m_settings = settings;
    m_accounts = {};
    m_bodyOf = {};
    m_used = {};
    m_smoothed = {};
    m_kept_J = m_withheld_J = 0.0;
}

double PassivityController::supplied_J() const noexcept {
    double sum = 0.0;
    for (const Account& account : m_accounts) {
        sum += account.open ? account.observer.supplied_J() : 0.0;
    }
    return sum;
}

double PassivityController::work_J() const noexcept {
    double sum = 0.0;
    for (const Account& account : m_accounts) {
        sum += account.open ? account.observer.work_J() : 0.0;
    }
    return sum;
}

double PassivityController::stored_J() const noexcept {
    double sum = 0.0;
    for (const Account& account : m_accounts) {
        sum += account.open ? account.stored_J : 0.0;
    }
    return sum;
}

double PassivityController::renderedEnergy_J(const PassivityContact& contact, double gain,
                                             int count) noexcept {
    if (gain <= 0.0) {
        return 0.0;
    }
    double energy = 0.0;
    for (int tool = 0; tool < count; ++tool) {
        const auto i = static_cast<std::size_t>(tool);
        const double s = std::min(1.0, contact.capRatio[i] / gain);
        const double held =
            contact.capKnee > 0.0 ? bentEnergy(gain / contact.capRatio[i], contact.capKnee) : s * (2.0 - s);
        energy += contact.share[i] * gain * contact.stored_J * held;
    }
    return energy;
}

bool PassivityController::apply(const Limits& limits, int count, const core::ToolStates& states,
                                const PassivityBodies& bodies, Wrenches& wrenches) noexcept {
    smooth(states);
    PassivityObserver::Ages late_ticks{};
    for (std::size_t i = 0; i < late_ticks.size(); ++i) {
        late_ticks[i] = limits[i].late_ticks;
    }
    for (std::size_t body = 0; body < m_accounts.size(); ++body) {
        if (m_used[body]) {
            m_accounts[body].observer.addWork(states, late_ticks);
        }
    }
    regroup(count, bodies);
    bool injected = false;
    const Wrenches asked = wrenches;
    for (std::size_t body = 0; body < m_accounts.size(); ++body) {
        if (m_used[body]) {
            injected =
                applyTo(m_accounts[body], limits, count, states, bodies.contacts[body], wrenches) || injected;
        } else {
            m_accounts[body].close();
        }
    }
    for (std::size_t i = 0; injected && i < static_cast<std::size_t>(count); ++i) {
        const core::ToolState& state = states.tools[i];
        const double work_J = core::kTickSeconds * ((asked[i].force - wrenches[i].force).dot(state.v_WT) +
                                                    (asked[i].torque - wrenches[i].torque).dot(state.w_WT));
        m_kept_J += std::isfinite(work_J) ? work_J : 0.0;
        m_withheld_J += std::isfinite(work_J) ? std::max(0.0, work_J) : 0.0;
    }
    return injected;
}

void PassivityController::smooth(const core::ToolStates& states) noexcept {
    constexpr double kShare = core::kTickSeconds / (kFilter_s + core::kTickSeconds);
    for (std::size_t i = 0; i < static_cast<std::size_t>(std::clamp(states.count, 0, core::kMaxTools)); ++i) {
        const core::ToolState& state = states.tools[i];
        if (!state.v_WT.allFinite() || !state.w_WT.allFinite()) {
            m_smoothed[i] = Smoothed{};
            continue;
        }
        m_smoothed[i].v += kShare * (state.v_WT - m_smoothed[i].v);
        m_smoothed[i].w += kShare * (state.w_WT - m_smoothed[i].w);
    }
}

void PassivityController::regroup(int count, const PassivityBodies& bodies) noexcept {
    const std::array<bool, core::kMaxTools> before = m_used;
    m_used = {};
    for (int tool = 0; tool < count; ++tool) {
        m_used[bodies.bodyOf[static_cast<std::size_t>(tool)]] = true;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(std::max(0, count)); ++i) {
        const std::size_t from = m_bodyOf[i];
        const std::size_t to = bodies.bodyOf[i];
        if (from == to || !before[from]) {
            continue;
        }
        const double had = m_accounts[from].observer.supplied_J();
        if (!m_used[from]) { // no tool stays behind
            m_accounts[from].observer.moveAll(m_accounts[to].observer);
        } else if (!before[to]) {
            const PassivityContact& contact = bodies.contacts[to];
            const double holds = renderedEnergy_J(contact, contact.gain, count);
            m_accounts[from].observer.move(std::clamp(holds, 0.0, std::max(0.0, had)),
                                           m_accounts[to].observer);
        }
    }
    m_bodyOf = bodies.bodyOf;
}

bool PassivityController::applyTo(Account& account, const Limits& limits, int count,
                                  const core::ToolStates& states, const PassivityContact& contact,
                                  Wrenches& wrenches) noexcept {
    account.open = contact.touching && contact.gain > 0.0;
    if (!account.open) {
        account.close();
        return false;
    }
    const double c = account.share;
    account.stored_J = renderedEnergy_J(contact, c * contact.gain, count);
    if (contact.gain != contact.gainBefore) {
        account.observer.credit(account.stored_J - renderedEnergy_J(contact, c * contact.gainBefore, count));
    }
    if (contact.givesWay)
        return giveWay(account, count, contact, wrenches);
    account.excess_J = account.stored_J - account.observer.supplied_J();
    return inject(account.excess_J, limits, count, states, contact, wrenches);
}

bool PassivityController::giveWay(Account& account, int count, const PassivityContact& contact,
                                  Wrenches& wrenches) const noexcept {
    const double allowed = m_settings.passivityExcess_J;
    account.settle(account.share < 1.0 ? allowed : kSurplus_J); // a body that has shaken gets no more surplus
                                                                // than this
    const double whole = renderedEnergy_J(contact, contact.gain, count); // at c = 1
    const double excess =
        account.stored_J - std::min(account.observer.supplied_J(), account.observer.late_J());
    if (excess > allowed && whole > kLoaded_J)
        account.fall(
            std::min(kFall * std::min(1.0, whole / allowed), (excess - allowed) / std::max(whole, allowed)));
    else if (excess < 0.0 && account.share < 1.0)
        account.recover(-excess / std::max(whole, kLoaded_J));
    account.stored_J = renderedEnergy_J(contact, account.share * contact.gain, count);
    account.excess_J = account.stored_J - account.observer.supplied_J();
    if (account.share == 1.0)
        return false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        if (contact.members[i]) {
            wrenches[i].force *= account.share;
            wrenches[i].torque *= account.share;
        }
    return true;
}

void PassivityController::Account::close() noexcept {
    observer.endContact();
    stored_J = excess_J = forgiven_J = 0.0;
    share = rise = 1.0;
    risen = open = false;
}

void PassivityController::Account::settle(double surplus_J) noexcept {
    const double excess = stored_J - observer.supplied_J();
    if (excess > 0.0) {
        const double paid = std::min({excess, kForgiven_W * core::kTickSeconds, kForgiven_J - forgiven_J});
        forgiven_J += paid;
        observer.settleSupplied(paid);
    } else if (excess < -surplus_J) {
        observer.settleSupplied(excess + surplus_J);
    }
    const double late = stored_J - observer.late_J();
    if (late > 0.0)
        observer.settleLate(std::min(late, kForgivenLate_W * core::kTickSeconds));
    else if (late < -surplus_J)
        observer.settleLate(late + surplus_J);
}

void PassivityController::Account::fall(double by) noexcept {
    share = std::max(kLeastShare, share - by);
    if (risen)
        rise *= 0.5; // the body shook again
    risen = false;
}

void PassivityController::Account::recover(double most) noexcept {
    share = std::min(1.0, share + std::min(rise * kRise, most));
    risen = true;
}

bool PassivityController::inject(double excess_J, const Limits& limits, int count,
                                 const core::ToolStates& states, const PassivityContact& contact,
                                 Wrenches& wrenches) const noexcept {
    // Σ(u·v + r² w·ω) over the touching tools: the power that damping of 1 N·s/m takes, W.
    double taken = 0.0;
    double rate2 = 0.0;  // Σ(u² + r² w²) over the same tools
    double speed2 = 0.0; // Σv² over the same tools
    double scale = std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    for (int tool = 0; tool < count; ++tool) {
        const auto i = static_cast<std::size_t>(tool);
        if (!limits[i].renders || contact.share[i] <= 0.0) {
            continue;
        }
        const double v2 = states.tools[i].v_WT.squaredNorm();
        speed2 += v2;
        const Smoothed& slow = m_smoothed[i];
        rate2 += slow.v.squaredNorm() + lever2(limits[i]) * slow.w.squaredNorm();
        taken += slow.v.dot(states.tools[i].v_WT) + lever2(limits[i]) * slow.w.dot(states.tools[i].w_WT);
        scale = std::min(scale, limits[i].scale);
        most = std::min(
            most, std::max(0.0, limits[i].damping_Ns_per_m / limits[i].scale - contact.damping_Ns_per_m[i]));
    }
    constexpr double kT = core::kTickSeconds;
    const double leak = 0.5 * contact.gain * contact.stiffness_N_per_m * speed2 * kT * kT;
    const double excess = excess_J + leak;
    const double slowest = m_settings.passivityMinimumSpeed_m_per_s;
    if (!(excess > m_settings.passivityExcess_J * scale) || !(rate2 > slowest * slowest * scale * scale)) {
        return false;
    }
    const double alpha = std::min(excess / (kT * std::max(taken, rate2)), contact.gain * most);
    for (int tool = 0; tool < count; ++tool) {
        const auto i = static_cast<std::size_t>(tool);
        if (!limits[i].renders || contact.share[i] <= 0.0) {
            continue;
        }
        addDamping(wrenches[i].force, m_smoothed[i].v, alpha);
        addDamping(wrenches[i].torque, m_smoothed[i].w, alpha * lever2(limits[i]));
    }
    return true;
}

void PassivityController::hold(const core::ToolStates& states, const core::ToolWrenches& commanded) noexcept {
    for (std::size_t body = 0; body < m_accounts.size(); ++body) {
        if (!m_used[body]) {
            m_accounts[body].observer.holdNothing();
            continue;
        }
        std::array<bool, core::kMaxTools> members{};
        for (std::size_t i = 0; i < members.size(); ++i) {
            members[i] = m_bodyOf[i] == body;
        }
        m_accounts[body].observer.hold(states, commanded, members);
    }
}

} // namespace chiron::haptics
