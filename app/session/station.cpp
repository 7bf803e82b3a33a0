// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/station.h"

#include "core/random.h"
#include "devices/drivers/simulated/simulated_device.h"

#include <filesystem>

namespace chiron::session {

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
