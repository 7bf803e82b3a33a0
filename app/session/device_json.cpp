// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/device_json.h"

#include "session/json_reader.h"

#include <algorithm>

namespace chiron::session {

namespace {

QJsonObject axisToJson(const devices::AxisDescriptor& axis) {
    return {{"id", QString::fromStdString(axis.id)},
            {"unit", axis.unit == devices::AxisUnit::metre ? "m" : "rad"},
            {"resolution", axis.resolution},
            {"minimum", axis.minimum},
            {"maximum", axis.maximum},
            {"continuous_rating", axis.continuousRating},
            {"coulomb_friction", axis.coulombFriction},
            {"viscous_friction", axis.viscousFriction}};
}

core::Result<devices::AxisDescriptor> axisFromJson(const QJsonObject& json) {
    JsonReader in(json, QStringLiteral("device.axes[]"));
    devices::AxisDescriptor axis;
    axis.id = in.text("id");
    axis.unit = in.oneOf("unit", "rad", "m") ? devices::AxisUnit::radian : devices::AxisUnit::metre;
    axis.resolution = in.number("resolution");
    axis.minimum = in.number("minimum");
    axis.maximum = in.number("maximum");
    axis.continuousRating = in.number("continuous_rating");
    axis.coulombFriction = in.number("coulomb_friction", 0.0);
    axis.viscousFriction = in.number("viscous_friction", 0.0);
    if (!in.ok())
        return tl::unexpected(in.error());
    return axis;
}

} // namespace

QJsonObject toJson(const devices::DeviceDescriptor& d) {
    QJsonArray axes;
    for (const auto& axis : d.axes)
        axes.append(axisToJson(axis));
    QJsonArray parameters;
    for (const double p : d.kinematicsParameters)
        parameters.append(p);
    QJsonObject json{{"driver", QString::fromStdString(d.driver)},
                     {"model", QString::fromStdString(d.model)},
                     {"kinematics", QString::fromStdString(d.kinematics)},
                     {"kinematics_parameters", parameters},
                     {"axes", axes},
                     {"jaw_resolution_rad", d.jawResolution_rad},
                     {"renders_force", d.rendersForce},
                     {"measures_force", d.measuresForce},
                     {"in_process", d.inProcess},
                     {"period_us", static_cast<double>(d.period_us)},
                     {"maximum_force_N", d.maximumForce_N},
                     {"maximum_torque_Nm", d.maximumTorque_Nm},
                     {"maximum_damping_Ns_per_m", d.maximumDamping_Ns_per_m},
                     {"friction_compensation", d.frictionCompensation}};
    // Without a serial number, the text is the same as before the field existed.
    if (!d.serialNumber.empty())
        json.insert("serial_number", QString::fromStdString(d.serialNumber));
    // Without an age, the text is the same as before the field existed, and the usual age applies.
    if (d.oldestSample_us != devices::kUsualOldestSample_us)
        json.insert("oldest_sample_us", static_cast<double>(d.oldestSample_us));
    return json;
}

core::Result<devices::DeviceDescriptor> descriptorFromJson(const QJsonObject& json) {
    JsonReader in(json, QStringLiteral("device"));
    devices::DeviceDescriptor d;
    d.driver = in.text("driver");
    d.model = in.text("model");
    d.kinematics = in.text("kinematics");
    d.kinematicsParameters = in.numbers("kinematics_parameters");
    for (const QJsonValue& value : in.array("axes")) {
        auto axis = axisFromJson(value.toObject());
        CHIRON_TRY(axis);
        d.axes.push_back(std::move(*axis));
    }
    d.jawResolution_rad = in.number("jaw_resolution_rad");
    d.rendersForce = in.boolean("renders_force");
    d.measuresForce = in.boolean("measures_force");
    d.inProcess = in.boolean("in_process");
    d.period_us = static_cast<std::uint32_t>(in.integer("period_us", 1, 10'000'000));
    d.maximumForce_N = in.number("maximum_force_N");
    d.maximumTorque_Nm = in.number("maximum_torque_Nm");
    d.maximumDamping_Ns_per_m = in.number("maximum_damping_Ns_per_m");
    d.frictionCompensation = in.number("friction_compensation", 0.0);
    d.serialNumber = json.contains(QLatin1String("serial_number")) ? in.text("serial_number") : std::string();
    if (json.contains(QLatin1String("oldest_sample_us")))
        d.oldestSample_us = static_cast<std::uint32_t>(in.integer("oldest_sample_us", 0, 10'000'000));
    if (!in.ok())
        return tl::unexpected(in.error());
    if (d.axes.empty() || d.axes.size() > core::kMaxCoordinates)
        return core::fail(core::ErrorCode::badInput, "device.axes: expected 1 to 8 axes");
    return d;
}

QJsonObject toJson(const devices::WorkspaceMapping& m) {
    QJsonObject json{{"origin_m", QJsonArray{m.origin_m[0], m.origin_m[1], m.origin_m[2]}},
                     {"scale", m.scale},
                     {"left_handed", m.leftHanded}};
    // If missing, the base is not turned, as in sessions stored before the field existed.
    if (m.turned())
        json.insert("base_turn", QJsonArray{m.q_WD[0], m.q_WD[1], m.q_WD[2], m.q_WD[3]});
    return json;
}

core::Result<devices::WorkspaceMapping> mappingFromJson(const QJsonObject& json) {
    JsonReader in(json, QStringLiteral("mapping"));
    devices::WorkspaceMapping m;
    const std::vector<double> origin = in.numbers("origin_m");
    m.scale = in.number("scale");
    m.leftHanded = in.boolean("left_handed");
    const bool turned = json.contains(QLatin1String("base_turn"));
    const std::vector<double> turn =
        turned ? in.numbers("base_turn") : std::vector<double>{1.0, 0.0, 0.0, 0.0};
    if (!in.ok())
        return tl::unexpected(in.error());
    if (turn.size() != 4 ||
        !(std::abs(std::hypot(turn[0], turn[1], std::hypot(turn[2], turn[3])) - 1.0) < 1e-6))
        return core::fail(core::ErrorCode::badInput,
                          "mapping.base_turn: expected the four parts w, x, y, z of a unit quaternion");
    std::copy(turn.begin(), turn.end(), m.q_WD.begin());
    if (origin.size() != 3 || !(m.scale > 0.0))
        return core::fail(core::ErrorCode::badInput,
                          "mapping: expected three origin coordinates and a positive scale");
    std::copy(origin.begin(), origin.end(), m.origin_m.begin());
    return m;
}

} // namespace chiron::session
