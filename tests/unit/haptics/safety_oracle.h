// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/safety_settings.h"
#include "haptics/safety_supervisor.h"
#include "unit/haptics/safety_oracle_tick.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace chiron::test {

/// States one invariant for each row of the supervisor's table and checks the answers against them. It keeps
/// its own books of how much gain each row can at most allow; it shares no code with the supervisor.
class SafetyOracle {
public:
    SafetyOracle(const haptics::SafetySettings& settings,
                 const std::vector<devices::DeviceDescriptor>& devices)
        : m_settings(settings), m_devices(devices) {}

    /// The name of the first row whose invariant does not hold, or an empty string.
    std::string check(const OracleTick& in, const haptics::SafetyOutput& out) {
        noteCommands(in);
        noteLatches(in);
        for (std::size_t i = 0; i < m_devices.size();
             ++i) // injected damping acts on the velocity after 2 ms of low-pass
            m_smoothed[i] = (2.0 * m_smoothed[i] + in.states[i].v_WT) / 3.0;
        std::string broken = checkStateless(in, out);
        if (broken.empty()) {
            broken = checkGains(in, out);
        }
        noteArming(in);
        for (std::size_t i = 0; i < m_devices.size(); ++i) {
            m_last[i] = out.tools[i].wrench_W;
        }
        ++m_tick;
        return broken;
    }

private:
    bool renders(std::size_t i) const {
        return m_devices[i].rendersForce && m_devices[i].period_us <= m_settings.slowestRendering_us;
    }
    static double finiteNorm(const core::Vec3& v) {
        const double most = v.cwiseAbs().maxCoeff();
        return most > 0.0 && std::isfinite(most) ? (v / most).norm() * most : most;
    }
    static bool isFinite(const core::Wrench& w) { return w.force.allFinite() && w.torque.allFinite(); }

    void withdrawArming() {
        m_permitted = -1;
        m_quiet = 0;
        m_still = 0;
        m_confirmed = false;
    }

    void noteCommands(const OracleTick& in) {
        bool stop = in.stopButton;
        for (const core::Command& command : in.commands) {
            if (command.kind == core::CommandKind::pause && m_pausedSince < 0) {
                m_pausedSince = m_tick;
            } else if (command.kind == core::CommandKind::resume && m_pausedSince >= 0) {
                m_pausedSince = -1;
                withdrawArming();
            } else if (command.kind == core::CommandKind::rearm && !in.stopButton &&
                       (m_stopped || m_faulted || m_overSpeed)) {
                m_stopped = false;
                m_faulted = false;
                m_overSpeed = false;
                withdrawArming();
            } else if (command.kind == core::CommandKind::confirmHold) {
                m_confirmed = true;
            } else if (command.kind == core::CommandKind::stopForce) {
                stop = true;
            }
        }
        m_stopped = m_stopped || stop;
        if (in.sceneChanged) {
            withdrawArming();
        }
        const bool frozen = m_settings.heartbeatWatched && in.heartbeatAge_ms >= m_settings.heartbeatLimit_ms;
        if (frozen && !m_frozenNow) {
            m_frozenSince = m_tick;
        }
        if (frozen) {
            m_windowPermitted = -1;
        }
        m_frozenNow = frozen;
    }

    void noteLatches(const OracleTick& in) {
        bool fault = in.deviceFault;
        for (std::size_t i = 0; i < m_devices.size(); ++i) {
            if (!renders(i)) {
                continue;
            }
            const std::uint32_t limit = std::max(m_settings.watchdogFault_us,
                                                 m_settings.watchdogFaultPeriods * m_devices[i].period_us);
            fault = fault || !isFinite(in.requested[i]) || in.goodAge_us[i] >= limit;
            fault =
                fault || (in.badInARow[i] >= static_cast<int>(m_settings.badPacketsToFault) && !rearmed(in));
        }
        m_faulted = m_faulted || fault;
    }

    /// Bad packets do not hold against a re-arm: their reference is taken anew.
    bool rearmed(const OracleTick& in) const {
        return std::any_of(in.commands.begin(), in.commands.end(),
                           [](const core::Command& c) { return c.kind == core::CommandKind::rearm; });
    }

    std::string checkStateless(const OracleTick& in, const haptics::SafetyOutput& out) {
        for (std::size_t i = 0; i < m_devices.size(); ++i) {
            const core::Wrench& w = out.tools[i].wrench_W;
            if (!isFinite(w)) {
                return "finite";
            }
            if (!renders(i)) {
                if (w.force != core::Vec3::Zero() || w.torque != core::Vec3::Zero() || out.tools[i].enabled) {
                    return "input only";
                }
                continue;
            }
            if (!capsHold(i, out.tools[i].wrench_D) || !capsHold(i, w)) {
                return "caps";
            }
            if (distance(m_last[i].force, w.force) > m_settings.slewForce_N_per_ms * 1.0000001 ||
                distance(m_last[i].torque, w.torque) > m_settings.slewTorque_Nm_per_ms * 1.0000001) {
                return "slew";
            }
            const double speed = in.states[i].v_WT.norm();
            m_overSpeed =
                m_overSpeed || (speed > m_settings.overVelocity_m_per_s && w.force != core::Vec3::Zero());
        }
        for (std::size_t i = 0; i < m_devices.size(); ++i) {
            const core::Vec3& f = out.tools[i].wrench_W.force;
            const core::Vec3& v = in.states[i].v_WT;
            if (m_overSpeed &&
                (f.dot(v) > 1e-9 || f.norm() > m_settings.overVelocityDamping_Ns_per_m * v.norm() + 1e-9)) {
                return "over-velocity";
            }
        }
        return {};
    }

    bool capsHold(std::size_t i, const core::Wrench& w) const {
        const auto& device = m_devices[i];
        const double force =
            std::min({device.maximumForce_N, m_settings.siteForce_N, m_settings.exerciseForce_N});
        const double torque =
            std::min({device.maximumTorque_Nm, m_settings.siteTorque_Nm, m_settings.exerciseTorque_Nm});
        bool hold = w.force.norm() <= force && w.torque.norm() <= torque;
        for (int axis = 0; axis < 3; ++axis) { // CartesianKinematics: the axes are D's
            const auto a = static_cast<std::size_t>(axis);
            hold = hold && std::abs(w.force[axis]) <= device.axes[a].continuousRating &&
                   std::abs(w.torque[axis]) <= device.axes[a + 3].continuousRating;
        }
        return hold;
    }

    /// How far an answer lies from where giving way alone could lead: the segment from zero to the answer
    /// before.
    static double distance(const core::Vec3& before, const core::Vec3& after) {
        double best = after.norm();
        if (before.norm() > 0.0) {
            const double along = std::clamp(after.dot(before) / before.squaredNorm(), 0.0, 1.0);
            best = std::min(best, (after - along * before).norm());
        }
        return best;
    }

    std::string checkGains(const OracleTick& in, const haptics::SafetyOutput& out) {
        if (m_stopped && !within(in, out, 0.0)) {
            return "stop";
        }
        if (m_faulted && !within(in, out, 0.0)) {
            return faultName(in);
        }
        if (!within(in, out, armingGain())) {
            return "arming";
        }
        if (m_pausedSince >= 0 && !within(in, out, ramp(m_pausedSince, m_settings.pauseRamp_ms))) {
            return "pause";
        }
        if (!within(in, out, windowGain())) {
            return "frozen window";
        }
        if (!within(in, out, watchdogGain(in))) {
            return "watchdog";
        }
        return {};
    }

    std::string faultName(const OracleTick& in) const {
        for (std::size_t i = 0; i < m_devices.size(); ++i) {
            if (renders(i) && in.badInARow[i] >= static_cast<int>(m_settings.badPacketsToFault)) {
                return "sanity";
            }
            if (renders(i) && !isFinite(in.requested[i])) {
                return "finite";
            }
        }
        return watchdogGain(in) < 1.0 ? "watchdog" : "fault";
    }

    double armingGain() const {
        return m_permitted < 0
                   ? 0.0
                   : std::min(1.0, static_cast<double>(m_tick - m_permitted) / m_settings.armingRamp_ms);
    }
    double ramp(std::int64_t since, std::uint32_t length) const {
        return std::max(0.0, 1.0 - static_cast<double>(m_tick - since + 1) / length);
    }
    double windowGain() const {
        if (m_frozenSince < 0) {
            return 1.0;
        }
        const double down = ramp(m_frozenSince, m_settings.heartbeatRamp_ms);
        const double up = m_windowPermitted < 0
                              ? 0.0
                              : static_cast<double>(m_tick - m_windowPermitted) / m_settings.armingRamp_ms;
        return std::min(1.0, std::max(down, up));
    }
    double watchdogGain(const OracleTick& in) const {
        double gain = 1.0;
        for (std::size_t i = 0; i < m_devices.size(); ++i) {
            if (!renders(i)) {
                continue;
            }
            const double start = std::max(m_settings.watchdogStart_us,
                                          m_settings.watchdogStartPeriods * m_devices[i].period_us);
            gain = std::min(gain, 1.0 - (in.goodAge_us[i] - start) / m_settings.watchdogRamp_us);
        }
        return std::max(0.0, gain);
    }

    /// ‖f‖ <= gain · (what was asked for + the most damping that may be injected), and exactly zero at gain
    /// 0.
    bool within(const OracleTick& in, const haptics::SafetyOutput& out, double gain) const {
        for (std::size_t i = 0; i < m_devices.size(); ++i) {
            const core::Wrench& w = out.tools[i].wrench_W;
            if (gain <= 0.0 && (w.force != core::Vec3::Zero() || w.torque != core::Vec3::Zero())) {
                return false;
            }
            const double asked = finiteNorm(in.requested[i].force);
            const double damping =
                std::max(m_devices[i].maximumDamping_Ns_per_m * m_smoothed[i].norm(),
                         m_settings.overVelocityDamping_Ns_per_m * in.states[i].v_WT.norm());
            if (w.force.norm() > gain * (asked + damping) * (1.0 + 1e-9) + 4e-9 * (1.0 + damping)) {
                return false;
            }
        }
        return true;
    }

    void noteArming(const OracleTick& in) {
        bool quiet = true;
        bool still = true;
        for (std::size_t i = 0; i < m_devices.size(); ++i) {
            if (!renders(i)) {
                continue;
            }
            quiet = quiet && finiteNorm(in.requested[i].force) < m_settings.armingForce_N &&
                    finiteNorm(in.requested[i].torque) < m_settings.armingTorque_Nm;
            still = still && in.states[i].v_WT.norm() < m_settings.stillSpeed_m_per_s;
        }
        m_quiet = quiet ? m_quiet + 1 : 0;
        m_still = still && (in.deadMan || m_confirmed) ? m_still + 1 : 0;
        const bool met = m_quiet >= m_settings.armingQuiet_ticks || m_still >= m_settings.stillTime_ms;
        if (met && m_permitted < 0) {
            m_permitted = m_tick;
        }
        if (met && !m_frozenNow && m_frozenSince >= 0 && m_windowPermitted < 0) {
            m_windowPermitted = m_tick;
        }
    }

    haptics::SafetySettings m_settings;
    std::vector<devices::DeviceDescriptor> m_devices;
    std::array<core::Wrench, core::kMaxTools> m_last{};
    std::array<core::Vec3, core::kMaxTools> m_smoothed{core::Vec3::Zero(), core::Vec3::Zero(),
                                                       core::Vec3::Zero(), core::Vec3::Zero()};
    std::int64_t m_tick = 0;
    std::int64_t m_permitted = -1;
    std::int64_t m_pausedSince = -1;
    std::int64_t m_frozenSince = -1;
    std::int64_t m_windowPermitted = -1;
    std::uint32_t m_quiet = 0;
    std::uint32_t m_still = 0;
    bool m_confirmed = false;
    bool m_stopped = false;
    bool m_faulted = false;
    bool m_overSpeed = false;
    bool m_frozenNow = false;
};

} // namespace chiron::test
