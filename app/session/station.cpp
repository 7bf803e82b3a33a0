// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/station.h"

#include "core/random.h"
#include "devices/drivers/simulated/simulated_device.h"
#include "devices/drivers/simulated/simulated_endoscope_device.h"
#include "simulation/exercises/urethra_insertion/procedure_plan.h"

#include <cmath>
#include <filesystem>
#include <span>

namespace chiron::session {

namespace {
constexpr double kFollowing_s = 0.025; // longer than a pointer's reports are apart, shorter than anybody notices

core::Vec3 endoscopeStart_W() {
    return simulation::AnatomyPose{}.pointToW({0.0, 0.0, -simulation::kStartBeforeEntrance_m});
}

/// A driver whose box of W stays the same whatever the scale, so that the hand's part of it shrinks as the scale grows.
template <class Device, class Settings>
core::Result<std::unique_ptr<Device>> makePointer(Settings settings, double scale) {
    settings.following_s = kFollowing_s;
    for (std::size_t i = 0; i < 3; ++i) {
        settings.minimum_m[i] /= scale;
        settings.maximum_m[i] /= scale;
        settings.home_m[i] /= scale;
    }
    return Device::create(settings);
}

/// One device a hand; each hand trembles for itself, the first as it always did.
template <class Device>
core::Result<Station> withDevices(Station station, const typename Device::Configuration& usual, ScriptedTrainee trainee,
                                  std::uint64_t handSeed, std::span<const devices::WorkspaceMapping> places) {
    for (std::size_t i = 0; i < trainee.strategies.size(); ++i) {
        typename Device::Configuration configuration = usual;
        configuration.seed = i == 0 ? handSeed : core::Random::mix(handSeed, "hand " + std::to_string(i));
        configuration.hand = trainee.hand;
        configuration.mapping = places[i];
        auto device = Device::create(configuration, std::move(trainee.strategies[i]));
        if (!device)
            return tl::unexpected(device.error());
        station.mappings.push_back(configuration.mapping);
        station.devices.push_back(std::move(*device));
    }
    return station;
}

core::Result<std::vector<devices::WorkspaceMapping>> placesOf(const ExerciseKind& kind, const catalogue::ExerciseLevel& level,
                                                              std::size_t hands) {
    const int tools = kind.toolCount(level);
    if (tools < 1 || tools > core::kMaxTools || hands != static_cast<std::size_t>(tools))
        return core::fail(core::ErrorCode::wrongUse, "exercise " + std::string(kind.id()) + ": " + std::to_string(hands) +
                                                         " hands for " + std::to_string(tools) + " instruments");
    std::vector<devices::WorkspaceMapping> places;
    for (int tool = 0; tool < tools; ++tool)
        places.push_back(kind.toolPlace(level, tool));
    return places;
}
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

core::Result<Station> keyboardMouseStation(const WorkspaceChoice& choice, PointerTool tool) {
    auto mapping = mappingOf(choice);
    if (!mapping)
        return tl::unexpected(mapping.error());
    Station station;
    station.mappings.push_back(*mapping);
    if (tool == PointerTool::point) {
        auto device = makePointer<devices::KeyboardMouseDevice>(devices::KeyboardMouseSettings{}, choice.scale);
        if (!device)
            return tl::unexpected(device.error());
        station.pointer = &(*device)->mailbox();
        station.devices.push_back(std::move(*device));
        return station;
    }
    devices::EndoscopePointerSettings settings;
    const core::Vec3 start_W = endoscopeStart_W();
    settings.home_m = {start_W.x(), start_W.y(), start_W.z()};
    auto device = makePointer<devices::EndoscopePointerDevice>(settings, choice.scale);
    if (!device)
        return tl::unexpected(device.error());
    station.endoscope = &(*device)->mailbox();
    station.devices.push_back(std::move(*device));
    return station;
}

core::Result<Station> scriptedStation(const ExerciseKind& kind, const catalogue::ExerciseLevel& level,
                                      const std::string& operatorName, std::uint64_t seed, mechanisms::PolarMap map) {
    // Hand and mind have streams of their own: the same person in another field trembles alike.
    auto trainee = kind.makeOperator(level, operatorName, core::Random::mix(seed, "operator"));
    if (!trainee)
        return tl::unexpected(trainee.error());
    const auto places = placesOf(kind, level, trainee->strategies.size());
    if (!places)
        return tl::unexpected(places.error());
    Station station;
    station.operatorName = operatorName;
    const std::uint64_t handSeed = core::Random::mix(seed, "hand");
    if (kind.mechanism() == devices::FiveBarSphericalKinematics::kId) {
        devices::SimulatedEndoscopeDevice::Configuration configuration;
        configuration.start_D = endoscopeStart_W(); // D is W where nothing else is said
        return withDevices<devices::SimulatedEndoscopeDevice>(std::move(station), configuration, std::move(*trainee), handSeed,
                                                              *places);
    }
    if (kind.mechanism() == devices::GimbalHprdKinematics::kId) {
        devices::SimulatedDevice::Configuration configuration;
        configuration.map = map;
        return withDevices<devices::SimulatedDevice>(std::move(station), configuration, std::move(*trainee), handSeed, *places);
    }
    return core::fail(core::ErrorCode::wrongUse,
                      "exercise " + std::string(kind.id()) + ": no simulated mechanism \"" + std::string(kind.mechanism()) +
                          "\"");
}

core::Result<Station> traceStation(const scoring::TraceRows& rows, PointerTool tool) {
    if (tool == PointerTool::endoscope && !rows.columns.orientation)
        return core::fail(core::ErrorCode::badInput,
                          rows.source + ": no orientation; an endoscope needs the columns qw, qx, qy and qz");
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
