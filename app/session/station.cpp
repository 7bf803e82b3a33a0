// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/station.h"

#include "core/random.h"
#include "devices/drivers/simulated/simulated_device.h"
#include "devices/drivers/simulated/simulated_endoscope_device.h"
#include "devices/drivers/simulated/simulated_fingertip_device.h"
#include "devices/drivers/simulated/simulated_second_finger.h"
#include "haptics/friction_compensation.h"
#include "simulation/exercises/urethra_insertion/procedure_plan.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>

namespace chiron::session {

namespace {
constexpr double kInside_m = 0.001;    // between where a grasper begins and the edge of its box
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

/// One arm a hand; further fingers of a hand are tools on the first one's arm.
core::Result<Station> withFingers(Station station, const FingersOfHand& fingers, ScriptedTrainee trainee, std::uint64_t handSeed,
                                  std::span<const devices::WorkspaceMapping> places) {
    const devices::SimulatedFingertipDevice* hand = nullptr;
    for (std::size_t i = 0; i < trainee.strategies.size(); ++i) {
        const int finger = static_cast<int>(i) % std::max(fingers.perHand, 1);
        const std::uint64_t seed = i == 0 ? handSeed : core::Random::mix(handSeed, "hand " + std::to_string(i));
        station.mappings.push_back(places[i - static_cast<std::size_t>(finger)]); // of its hand
        if (finger > 0) {
            auto device = devices::SimulatedSecondFinger::create(*hand, {finger * fingers.spacing_m, 0.0, 0.0}, seed,
                                                                 std::move(trainee.strategies[i]));
            if (!device)
                return tl::unexpected(device.error());
            station.devices.push_back(std::move(*device));
            continue;
        }
        devices::SimulatedFingertipDevice::Configuration configuration;
        configuration.seed = seed;
        configuration.hand = trainee.hand;
        configuration.mapping = station.mappings.back();
        auto device = devices::SimulatedFingertipDevice::create(configuration, std::move(trainee.strategies[i]));
        if (!device)
            return tl::unexpected(device.error());
        hand = device->get();
        station.devices.push_back(std::move(*device));
    }
    return station;
}

tl::unexpected<core::Error> differingHands(const ExerciseKind& kind, std::size_t hands, std::size_t tools) {
    return core::fail(core::ErrorCode::wrongUse, "exercise " + std::string(kind.id()) + ": " + std::to_string(hands) + " hands for " +
                                                     std::to_string(tools) + " instruments");
}

WorkspaceChoice mountingOf(const catalogue::ExerciseLevel& level, int tool, const WorkspaceChoice& chosen) {
    const auto index = static_cast<std::size_t>(tool);
    return index < level.mounting.size() ? chosen.over(level.mounting[index]) : chosen;
}

/// A pointer has no base that could be turned.
WorkspaceChoice ofPointer(WorkspaceChoice choice) {
    choice.turn_rad = {};
    return choice;
}

/// Where the devices of a level stand: the kind's places, each mounted as chosen or else as the level says, about that place.
core::Result<std::vector<devices::WorkspaceMapping>> placesOf(const ExerciseKind& kind, const catalogue::ExerciseLevel& level,
                                                              std::size_t hands, const WorkspaceChoice& chosen) {
    const int tools = kind.toolCount(level);
    if (tools < 1 || tools > core::kMaxTools || hands != static_cast<std::size_t>(tools))
        return differingHands(kind, hands, static_cast<std::size_t>(std::max(tools, 0)));
    if (auto valid = mappingOf(chosen); !valid)
        return tl::unexpected(valid.error());
    const WorkspaceChoice unchanged;
    const bool any = chosen.turned() || chosen.leftHanded || chosen.scale != unchanged.scale || chosen.origin_m != unchanged.origin_m;
    if (any && !kind.operatorsKnowTheirPlace())
        return core::fail(core::ErrorCode::wrongUse, "exercise " + std::string(kind.id()) +
                                                         ": its scripted hands hold a device that stands as it is built; only those of "
                                                         "elastic_tube, object_handling and palpation can be mounted otherwise");
    std::vector<devices::WorkspaceMapping> places;
    for (int tool = 0; tool < tools; ++tool) {
        const auto mounted = mappingOf(mountingOf(level, tool, chosen));
        if (!mounted)
            return tl::unexpected(mounted.error());
        devices::WorkspaceMapping place = kind.toolPlace(level, tool);
        for (std::size_t i = 0; i < 3; ++i)
            place.origin_m[i] += mounted->origin_m[i];
        place.scale *= mounted->scale;
        place.leftHanded = place.leftHanded != mounted->leftHanded;
        if (mounted->turned())
            place.q_WD = mounted->q_WD;
        places.push_back(place);
    }
    return places;
}

devices::TracePoint pointOf(const scoring::TraceRow& row, const scoring::TraceColumns& columns) {
    devices::TracePoint point;
    point.t_s = row.t_s;
    point.p_WT_m = row.p_WT_m;
    if (columns.orientation)
        point.q_WT = row.q_WT;
    point.jaw_rad = row.jaw_rad;
    point.buttons = row.buttons;
    return point;
}

/// From the earliest time of any tool to the latest: one clock for all.
void playTogether(std::vector<std::vector<devices::TracePoint>>& tools) {
    double begin_s = tools.front().front().t_s;
    double end_s = tools.front().back().t_s;
    for (const auto& tool : tools) {
        begin_s = std::min(begin_s, tool.front().t_s);
        end_s = std::max(end_s, tool.back().t_s);
    }
    for (auto& tool : tools) {
        if (devices::TracePoint waiting = tool.front(); waiting.t_s > begin_s) {
            waiting.t_s = begin_s;
            waiting.buttons = 0;
            tool.insert(tool.begin(), waiting);
        }
        if (devices::TracePoint resting = tool.back(); resting.t_s < end_s) {
            resting.t_s = end_s;
            tool.push_back(resting);
        }
    }
}

/// A finger's reach, and the jaw that its hand can close (0: none). `start_m`: where it begins, z in W.
devices::KeyboardMouseSettings fingerSettings(double widestJaw_rad, const devices::WorkspaceMapping& mapping, std::optional<double> start_m) {
    devices::KeyboardMouseSettings settings;
    settings.widestJaw_rad = widestJaw_rad;
    if (start_m)
        settings.home_m[2] = std::clamp(*start_m - mapping.origin_m[2], settings.minimum_m[2] + kInside_m, settings.maximum_m[2] - kInside_m);
    return settings;
}

std::optional<double> startOf(const ExerciseKind& kind, const catalogue::ExerciseLevel& level, const devices::WorkspaceMapping& mapping) {
    return kind.pointerStart_m(level, mapping.origin_m[0], mapping.origin_m[1]); // a pointer begins in the middle of its box
}

/// What all graspers reach, as seen from each tool's own place; each begins under its entry point, its jaw open.
devices::KeyboardMouseSettings grasperSettings(const devices::WorkspaceMapping& mapping, const std::array<double, 3>& middle_m) {
    devices::KeyboardMouseSettings settings;
    const double mirror = mapping.leftHanded ? -1.0 : 1.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double aside = (i == 0 ? mirror : 1.0) * (middle_m[i] - mapping.origin_m[i]);
        const double least = settings.minimum_m[i] + aside;
        const double most = settings.maximum_m[i] + aside;
        settings.home_m[i] = std::clamp(settings.home_m[i], least + kInside_m, most - kInside_m);
        settings.minimum_m[i] = least;
        settings.maximum_m[i] = most;
    }
    settings.widestJaw_rad = mechanisms::JawParameters{}.widest_rad;
    settings.homeJaw_rad = settings.widestJaw_rad; // an instrument that comes closed cannot take hold of anything
    return settings;
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
    for (const double turn_rad : choice.turn_rad) {
        if (!(std::abs(turn_rad) <= W::kLargestTurn_rad + 1e-12))
            return core::fail(core::ErrorCode::badInput, "workspace: a turn of the base of " + std::to_string(turn_rad) +
                                                             " rad; expected at most 45 degrees either way");
    }
    devices::WorkspaceMapping mapping{choice.origin_m, choice.scale, choice.leftHanded, {1.0, 0.0, 0.0, 0.0}};
    if (choice.turned()) {
        const core::Quat turn = Eigen::AngleAxisd(choice.turn_rad[0], core::Vec3::UnitZ()) *
                                Eigen::AngleAxisd(-choice.turn_rad[1], core::Vec3::UnitX()) *
                                Eigen::AngleAxisd(choice.turn_rad[2], core::Vec3::UnitY());
        mapping.q_WD = {turn.w(), turn.x(), turn.y(), turn.z()};
    }
    return mapping;
}

namespace {
core::Result<Station> onePointerStation(const WorkspaceChoice& choice, PointerTool tool, const devices::KeyboardMouseSettings& finger) {
    auto mapping = mappingOf(choice);
    if (!mapping)
        return tl::unexpected(mapping.error());
    Station station;
    station.mappings.push_back(*mapping);
    if (tool == PointerTool::point) {
        auto device = makePointer<devices::KeyboardMouseDevice>(finger, choice.scale);
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

/// A pointer is mounted nowhere: each tool stands where the kind puts it, with the workspace that the person chose.
core::Result<std::vector<devices::WorkspaceMapping>> pointerPlaces(const ExerciseKind& kind, const catalogue::ExerciseLevel& level,
                                                                   const WorkspaceChoice& choice) {
    const auto chosen = mappingOf(choice);
    if (!chosen)
        return tl::unexpected(chosen.error());
    const int tools = kind.toolCount(level);
    if (tools < 1 || tools > core::kMaxTools)
        return differingHands(kind, static_cast<std::size_t>(std::max(tools, 0)), static_cast<std::size_t>(std::max(tools, 0)));
    std::vector<devices::WorkspaceMapping> places;
    for (int tool = 0; tool < tools; ++tool) {
        devices::WorkspaceMapping mapping = *chosen;
        for (std::size_t i = 0; i < 3; ++i)
            mapping.origin_m[i] += kind.toolPlace(level, tool).origin_m[i];
        places.push_back(mapping);
    }
    return places;
}
} // namespace

core::Result<Station> keyboardMouseStation(const WorkspaceChoice& given, PointerTool tool, double widestJaw_rad) {
    return onePointerStation(ofPointer(given), tool, fingerSettings(widestJaw_rad, {}, {}));
}

core::Result<Station> keyboardMouseStation(const WorkspaceChoice& given, const ExerciseKind& kind,
                                           const catalogue::ExerciseLevel& level) {
    const WorkspaceChoice choice = ofPointer(given);
    const bool fingers = kind.pointerTool() == PointerTool::point && kind.toolCount(level) > 1;
    if (kind.pointerTool() != PointerTool::grasper && !fingers) {
        const auto mapping = mappingOf(choice);
        if (!mapping)
            return tl::unexpected(mapping.error());
        return onePointerStation(choice, kind.pointerTool(), fingerSettings(kind.fingerJaw_rad(level), *mapping, startOf(kind, level, *mapping)));
    }
    const auto places = pointerPlaces(kind, level, choice);
    if (!places)
        return tl::unexpected(places.error());
    Station station;
    for (const devices::WorkspaceMapping& mapping : *places) {
        const auto settings = fingers ? fingerSettings(kind.fingerJaw_rad(level), mapping, startOf(kind, level, mapping))
                                      : grasperSettings(mapping, choice.origin_m);
        auto device = makePointer<devices::KeyboardMouseDevice>(settings, choice.scale);
        if (!device)
            return tl::unexpected(device.error());
        (fingers ? station.fingers : station.graspers).push_back(&(*device)->mailbox());
        station.mappings.push_back(mapping);
        station.devices.push_back(std::move(*device));
    }
    return station;
}

core::Result<Station> scriptedStation(const ExerciseKind& kind, const catalogue::ExerciseLevel& level, const std::string& operatorName,
                                      std::uint64_t seed, mechanisms::PolarMap map, std::string_view mechanism,
                                      const WorkspaceChoice& mounting) {
    const std::vector<std::string_view> known = kind.mechanisms();
    const std::string_view chosen = mechanism.empty() ? kind.mechanism() : mechanism;
    if (std::find(known.begin(), known.end(), chosen) == known.end())
        return core::fail(core::ErrorCode::wrongUse, "mechanism \"" + std::string(chosen) + "\": exercise " + std::string(kind.id()) +
                                                         " is not done on it");
    // Hand and mind have streams of their own: the same person in another field trembles alike.
    const auto hands = static_cast<std::size_t>(std::max(kind.toolCount(level), 0));
    auto places = placesOf(kind, level, hands, mounting);
    if (!places)
        return tl::unexpected(places.error());
    auto trainee = kind.makeOperatorAt(*places, chosen, level, operatorName, core::Random::mix(seed, "operator"));
    if (!trainee)
        return tl::unexpected(trainee.error());
    if (trainee->strategies.size() != hands)
        return differingHands(kind, trainee->strategies.size(), hands);
    Station station;
    station.operatorName = operatorName;
    const std::uint64_t handSeed = core::Random::mix(seed, "hand");
    if (chosen == devices::FiveBarSphericalKinematics::kId) {
        devices::SimulatedEndoscopeDevice::Configuration configuration;
        configuration.start_D = endoscopeStart_W(); // D is W where nothing else is said
        return withDevices<devices::SimulatedEndoscopeDevice>(std::move(station), configuration, std::move(*trainee), handSeed,
                                                              *places);
    }
    if (chosen == devices::GimbalHprdKinematics::kId) {
        devices::SimulatedDevice::Configuration configuration;
        configuration.map = map;
        configuration.frictionCompensation = haptics::FrictionCompensation::kMost;
        if (kind.pointerTool() == PointerTool::grasper)
            configuration.jaw = mechanisms::JawParameters{};
        return withDevices<devices::SimulatedDevice>(std::move(station), configuration, std::move(*trainee), handSeed, *places);
    }
    if (chosen == devices::FingertipArmKinematics::kId)
        return withFingers(std::move(station), kind.fingers(level), std::move(*trainee), handSeed, *places);
    return core::fail(core::ErrorCode::wrongUse,
                      "exercise " + std::string(kind.id()) + ": no simulated mechanism \"" + std::string(chosen) +
                          "\"");
}

core::Result<Station> traceStation(const scoring::TraceRows& rows, PointerTool tool, int tools) {
    const auto refuse = [&rows](const std::string& why) { return core::fail(core::ErrorCode::badInput, rows.source + ": " + why); };
    if (tool == PointerTool::endoscope && !rows.columns.orientation)
        return refuse("no orientation; an endoscope needs the columns qw, qx, qy and qz");
    if (tool == PointerTool::grasper && !rows.columns.jaw)
        return refuse("no jaw; a grasper needs the column jaw_deg");
    if (tools < 1 || tools > core::kMaxTools)
        return core::fail(core::ErrorCode::wrongUse, "trace: " + std::to_string(tools) + " instruments, expected 1 to 4");
    std::vector<std::vector<devices::TracePoint>> points(static_cast<std::size_t>(tools));
    for (const scoring::TraceRow& row : rows.rows)
        if (row.tool < tools) // more hands than the level has instruments: the others are left out
            points[row.tool].push_back(pointOf(row, rows.columns));
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].empty())
            return refuse("no row of tool " + std::to_string(i) + "; the level needs rows of tools 0 to " +
                          std::to_string(tools - 1) + " (column tool)");
    playTogether(points);
    Station station;
    for (std::size_t i = 0; i < points.size(); ++i) {
        auto device = devices::ReplayDevice::create(points[i]);
        if (!device)
            return refuse((tools > 1 ? "tool " + std::to_string(i) + ": " : std::string()) + device.error().message);
        if (i == 0)
            station.trace = device->get();
        station.mappings.emplace_back();
        station.devices.push_back(std::move(*device));
    }
    station.operatorName = "trace:" + std::filesystem::path(rows.source).filename().string();
    return station;
}

} // namespace chiron::session
