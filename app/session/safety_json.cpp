// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/safety_json.h"

#include "session/json_reader.h"

#include <limits>
#include <string_view>
#include <type_traits>

namespace chiron::session {

namespace {

/// Lists every field once, for both directions. A new field of SafetySettings must be added here (a test
/// counts them).
template <class Settings, class Field> void eachField(Settings& settings, Field&& field) {
    field("siteForce_N", settings.siteForce_N);
    field("siteTorque_Nm", settings.siteTorque_Nm);
    field("exerciseForce_N", settings.exerciseForce_N);
    field("exerciseTorque_Nm", settings.exerciseTorque_Nm);
    field("capKnee", settings.capKnee);
    field("slewForce_N_per_ms", settings.slewForce_N_per_ms);
    field("slewTorque_Nm_per_ms", settings.slewTorque_Nm_per_ms);
    field("armingForce_N", settings.armingForce_N);
    field("armingTorque_Nm", settings.armingTorque_Nm);
    field("armingQuiet_ticks", settings.armingQuiet_ticks);
    field("stillSpeed_m_per_s", settings.stillSpeed_m_per_s);
    field("stillTime_ms", settings.stillTime_ms);
    field("armingRamp_ms", settings.armingRamp_ms);
    field("overVelocity_m_per_s", settings.overVelocity_m_per_s);
    field("overVelocityDamping_Ns_per_m", settings.overVelocityDamping_Ns_per_m);
    field("quaternionTolerance", settings.quaternionTolerance);
    field("jump_m", settings.jump_m);
    field("badPacketsToFault", settings.badPacketsToFault);
    field("watchdogStart_us", settings.watchdogStart_us);
    field("watchdogStartPeriods", settings.watchdogStartPeriods);
    field("watchdogRamp_us", settings.watchdogRamp_us);
    field("watchdogFault_us", settings.watchdogFault_us);
    field("watchdogFaultPeriods", settings.watchdogFaultPeriods);
    field("slowestRendering_us", settings.slowestRendering_us);
    field("noMovement_us", settings.noMovement_us);
    field("heartbeatWatched", settings.heartbeatWatched);
    field("heartbeatLimit_ms", settings.heartbeatLimit_ms);
    field("heartbeatRamp_ms", settings.heartbeatRamp_ms);
    field("pauseRamp_ms", settings.pauseRamp_ms);
    field("passivityExcess_J", settings.passivityExcess_J);
    field("passivityMinimumSpeed_m_per_s", settings.passivityMinimumSpeed_m_per_s);
}

} // namespace

QJsonObject toJson(const haptics::SafetySettings& settings) {
    QJsonObject json;
    eachField(settings, [&json](const char* name, const auto& value) {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, bool>)
            json.insert(QLatin1String(name), value);
        else
            json.insert(QLatin1String(name), static_cast<double>(value));
    });
    return json;
}

core::Result<haptics::SafetySettings> safetyFromJson(const QJsonObject& json) {
    haptics::SafetySettings settings;
    JsonReader in(json, QStringLiteral("supervisor"));
    eachField(settings, [&in](const char* name, auto& value) {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, bool>)
            value = in.boolean(name);
        else if constexpr (std::is_same_v<Value, double>)
            // Versions before this field existed cut forces off.
            value = name == std::string_view("capKnee") ? in.number(name, 0.0) : in.number(name);
        else
            value = static_cast<Value>(in.integer(name, 0, std::numeric_limits<Value>::max()));
    });
    if (!in.ok())
        return tl::unexpected(in.error());
    return settings;
}

} // namespace chiron::session
