// SPDX-License-Identifier: GPL-3.0-or-later
// Set-up of the supervisor. It may allocate (error texts), so it is kept apart from the code of the tick.
#include "haptics/safety_supervisor.h"
#include "haptics/safety_watchdog.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace chiron::haptics {

namespace {

using core::ErrorCode;

constexpr std::uint32_t kLongestRamp_ms = 30'000; ///< the gain is counted in billionths

bool isPositive(double value) {
    return std::isfinite(value) && value > 0.0;
}

core::Result<void> checkSettings(const SafetySettings& s) {
    const std::pair<const char*, double> positive[] = {
        {"siteForce_N", s.siteForce_N},
        {"siteTorque_Nm", s.siteTorque_Nm},
        {"exerciseForce_N", s.exerciseForce_N},
        {"exerciseTorque_Nm", s.exerciseTorque_Nm},
        {"slewForce_N_per_ms", s.slewForce_N_per_ms},
        {"slewTorque_Nm_per_ms", s.slewTorque_Nm_per_ms},
        {"armingForce_N", s.armingForce_N},
        {"armingTorque_Nm", s.armingTorque_Nm},
        {"stillSpeed_m_per_s", s.stillSpeed_m_per_s},
        {"overVelocity_m_per_s", s.overVelocity_m_per_s},
        {"overVelocityDamping_Ns_per_m", s.overVelocityDamping_Ns_per_m},
        {"quaternionTolerance", s.quaternionTolerance},
        {"jump_m", s.jump_m},
        {"passivityExcess_J", s.passivityExcess_J},
        {"passivityMinimumSpeed_m_per_s", s.passivityMinimumSpeed_m_per_s},
        {"armingQuiet_ticks", s.armingQuiet_ticks},
        {"stillTime_ms", s.stillTime_ms},
        {"armingRamp_ms", s.armingRamp_ms},
        {"badPacketsToFault", s.badPacketsToFault},
        {"watchdogRamp_us", s.watchdogRamp_us},
        {"slowestRendering_us", s.slowestRendering_us},
        {"heartbeatLimit_ms", s.heartbeatLimit_ms},
        {"heartbeatRamp_ms", s.heartbeatRamp_ms},
        {"pauseRamp_ms", s.pauseRamp_ms},
    };
    for (const auto& [name, value] : positive) {
        if (!isPositive(value)) {
            return core::fail(ErrorCode::badInput, std::string("safety settings: ") + name + " is " +
                                                       std::to_string(value) +
                                                       "; it must be finite and above 0");
        }
    }
    if (!(s.capKnee >= 0.0 && s.capKnee <= 0.5)) {
        return core::fail(ErrorCode::badInput,
                          "safety settings: capKnee is " + std::to_string(s.capKnee) + "; expected 0 to 0.5");
    }
    for (const std::uint32_t ramp_ms : {s.armingRamp_ms, s.heartbeatRamp_ms, s.pauseRamp_ms}) {
        if (ramp_ms > kLongestRamp_ms) {
            return core::fail(ErrorCode::badInput, "safety settings: a ramp of " + std::to_string(ramp_ms) +
                                                       " ms; at most " + std::to_string(kLongestRamp_ms));
        }
    }
    // The heartbeat's age saturates at 65,535 ms: a limit beyond it would never be reached.
    if (s.heartbeatLimit_ms > 65'535) {
        return core::fail(ErrorCode::badInput, "safety settings: heartbeatLimit_ms is " +
                                                   std::to_string(s.heartbeatLimit_ms) + "; at most 65535");
    }
    return {};
}

/// True if the tool may render force at its period.
bool rendersForce(const SafetySettings& settings, const SafetyTool& tool) {
    return tool.device.rendersForce && tool.device.period_us <= settings.slowestRendering_us;
}

/// Age of the tool's samples in whole ticks.
std::uint32_t lateTicks(const SafetyTool& tool) {
    constexpr std::uint32_t kTick_us = 1000;
    return (tool.device.guardedDelay_us() + kTick_us - 1) / kTick_us;
}

core::Result<void> checkTool(const SafetySettings& settings, const SafetyTool& tool, std::size_t index) {
    const std::string where =
        "safety supervisor: tool " + std::to_string(index) + " (" + tool.device.driver + "): ";
    const auto& axes = tool.device.axes;
    if (axes.empty() || axes.size() > static_cast<std::size_t>(core::kMaxCoordinates)) {
        return core::fail(ErrorCode::badInput,
                          where + std::to_string(axes.size()) + " axes; 1 to 8 are possible");
    }
    for (const auto& axis : axes) {
        if (!std::isfinite(axis.continuousRating) || axis.continuousRating < 0.0) {
            return core::fail(ErrorCode::badInput, where + "axis " + axis.id +
                                                       " has a continuous rating of " +
                                                       std::to_string(axis.continuousRating));
        }
    }
    if (tool.device.period_us == 0) {
        return core::fail(ErrorCode::badInput, where + "the declared period is 0");
    }
    if (!isPositive(tool.mapping.scale)) {
        return core::fail(ErrorCode::badInput, where + "the workspace scale is " +
                                                   std::to_string(tool.mapping.scale) +
                                                   "; it must be above 0");
    }
    for (const double value :
         {tool.device.maximumForce_N, tool.device.maximumTorque_Nm, tool.device.maximumDamping_Ns_per_m}) {
        if (!std::isfinite(value) || value < 0.0) {
            return core::fail(ErrorCode::badInput, where + "a maximum of " + std::to_string(value) +
                                                       " (force, torque or damping)");
        }
    }
    if (rendersForce(settings, tool) && lateTicks(tool) > PassivityObserver::kMostLate_ticks) {
        return core::fail(ErrorCode::device,
                          where + "its samples are up to " + std::to_string(tool.device.guardedDelay_us()) +
                              " us old; a device that renders force may send none older than " +
                              std::to_string(1000 * PassivityObserver::kMostLate_ticks) +
                              " us. Use a faster connection, and end other programs that keep this "
                              "computer busy");
    }
    return {};
}

SafetyToolLimits limitsOf(const SafetySettings& settings, const SafetyTool& tool) {
    SafetyToolLimits limits;
    limits.kinematics = &tool.kinematics;
    limits.renders = rendersForce(settings, tool);
    limits.inProcess = tool.device.inProcess;
    limits.map = devices::WorkspaceMap(tool.mapping);
    limits.scale = tool.mapping.scale;
    limits.period_us = tool.device.period_us;
    limits.late_ticks = static_cast<std::uint8_t>(
        std::min<std::uint32_t>(lateTicks(tool), PassivityObserver::kMostLate_ticks));
    setWatchdog(settings, limits);
    limits.axes = static_cast<int>(tool.device.axes.size());
    for (std::size_t i = 0; i < tool.device.axes.size(); ++i) {
        limits.axisCap[i] = tool.device.axes[i].continuousRating;
    }
    limits.pushesHand =
        std::any_of(tool.device.axes.begin(), tool.device.axes.end(),
                    [](const devices::AxisDescriptor& axis) { return axis.continuousRating > 0.0; });
    limits.forceCap_N =
        std::min({tool.device.maximumForce_N, settings.siteForce_N, settings.exerciseForce_N});
    limits.torqueCap_Nm =
        std::min({tool.device.maximumTorque_Nm, settings.siteTorque_Nm, settings.exerciseTorque_Nm});
    limits.damping_Ns_per_m = tool.device.maximumDamping_Ns_per_m;
    return limits;
}

} // namespace

core::Result<void> SafetySupervisor::configure(const SafetySettings& settings,
                                               std::span<const SafetyTool> tools) {
    if (tools.empty() || tools.size() > static_cast<std::size_t>(core::kMaxTools)) {
        return core::fail(ErrorCode::badInput, "safety supervisor: " + std::to_string(tools.size()) +
                                                   " tools; 1 to 4 are possible");
    }
    CHIRON_TRY(checkSettings(settings));
    for (std::size_t i = 0; i < tools.size(); ++i) {
        CHIRON_TRY(checkTool(settings, tools[i], i));
    }
    m_settings = settings;
    m_count = static_cast<int>(tools.size());
    for (std::size_t i = 0; i < tools.size(); ++i) {
        m_limits[i] = limitsOf(settings, tools[i]);
        m_sanity[i].reset(settings, m_limits[i].period_us, m_mask.has(GuardMask::kSanity));
    }
    m_machine.reset(settings, m_mask);
    m_passivity.reset(settings);
    m_last = Wrenches{};
    m_lastDisplay = {};
    m_lastGain = 0.0;
    m_guards = 0;
    m_requestFinite = true;
    m_answerFinite = true;
    return {};
}

} // namespace chiron::haptics
