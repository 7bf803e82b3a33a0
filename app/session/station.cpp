// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/station.h"

#include "core/random.h"
#include "devices/drivers/simulated/simulated_device.h"

#include <cmath>
#include <filesystem>

namespace chiron::session {

namespace {
constexpr double kFollowing_s = 0.025; // longer than a pointer's reports are apart, shorter than anybody notices
} // namespace

core::Result<devices::WorkspaceMapping> mappingOf(const WorkspaceChoice& choice) {
    using W = WorkspaceChoice;
    if (!(choice.scale >= W::kSmallestScale && choice.scale <= W::kLargestScale))
        return core::fail(core::ErrorCode::badInput, "workspace: a scale of " + std::to_string(choice.scale) +
                                                         "; expected 0.25 to 4");
    for (const double shift_m : choice.origin_m) {
        if (!(std::abs(shift_m) <= W::kLargestShift_m))
            return core::fail(core::ErrorCode::badInput, "workspace: a shift of " + std::to_string(shift_m) +
                                                             " m; expected at most 0.03 m either way");
    }
    return devices::WorkspaceMapping{choice.origin_m, choice.scale, choice.leftHanded};
}

core::Result<Station> keyboardMouseStation(const WorkspaceChoice& choice) {
    auto mapping = mappingOf(choice);
    if (!mapping)
        return tl::unexpected(mapping.error());
    devices::KeyboardMouseSettings settings;
    settings.following_s = kFollowing_s;
    for (std::size_t i = 0; i < 3; ++i) {
        settings.minimum_m[i] /= choice.scale;
        settings.maximum_m[i] /= choice.scale;
        settings.home_m[i] /= choice.scale;
    }
    auto device = devices::KeyboardMouseDevice::create(settings);
    if (!device)
        return tl::unexpected(device.error());
    Station station;
    station.pointer = &(*device)->mailbox();
    station.mappings.push_back(*mapping);
    station.devices.push_back(std::move(*device));
    return station;
}

core::Result<Station> scriptedStation(const ExerciseKind& kind, const std::string& operatorName, std::uint64_t seed) {
    // Hand and mind have streams of their own: the same person in another field trembles alike.
    auto trainee = kind.makeOperator(operatorName, core::Random::mix(seed, "operator"));
    if (!trainee)
        return tl::unexpected(trainee.error());
    devices::SimulatedDevice::Configuration configuration;
    configuration.seed = core::Random::mix(seed, "hand");
    configuration.hand = trainee->hand;
    auto device = devices::SimulatedDevice::create(configuration, std::move(trainee->strategy));
    if (!device)
        return tl::unexpected(device.error());
    Station station;
    station.mappings.push_back(configuration.mapping);
    station.devices.push_back(std::move(*device));
    station.operatorName = operatorName;
    return station;
}

core::Result<Station> traceStation(const scoring::TraceRows& rows) {
    std::vector<devices::TracePoint> points;
    for (const scoring::TraceRow& row : rows.rows) {
        if (row.tool != 0) // one hand plays; the others of a several-handed recording are left out
            continue;
        devices::TracePoint point;
        point.t_s = row.t_s;
        point.p_WT_m = row.p_WT_m;
        if (rows.columns.orientation)
            point.q_WT = row.q_WT;
        point.jaw_rad = row.jaw_rad;
        point.buttons = row.buttons;
        points.push_back(point);
    }
    auto device = devices::ReplayDevice::create(points);
    if (!device)
        return core::fail(device.error().code, rows.source + ": " + device.error().message);
    Station station;
    station.trace = device->get();
    station.mappings.emplace_back();
    station.devices.push_back(std::move(*device));
    station.operatorName = "trace:" + std::filesystem::path(rows.source).filename().string();
    return station;
}

} // namespace chiron::session
