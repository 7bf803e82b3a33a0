// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/station.h"

#include "core/random.h"
#include "haptics/friction_compensation.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>

namespace chiron::session {

namespace {
/// Requests a device from the driver for each tool of the request.
core::Result<Station> stationOf(const devices::Driver& driver, devices::DriverRequest request) {
    Station station;
    for (const devices::ToolRequest& tool : request.tools)
        station.tools.push_back({nullptr, tool.mapping, {}});
    auto made = driver.open(std::move(request));
    CHIRON_TRY(made);
    if (made->size() != station.tools.size())
        return core::fail(core::ErrorCode::device, "device " + std::string(driver.id) + ": " +
                                                       std::to_string(made->size()) + " tools for " +
                                                       std::to_string(station.tools.size()));
    for (std::size_t i = 0; i < made->size(); ++i) {
        station.tools[i].device = std::move((*made)[i].device);
        station.tools[i].input = (*made)[i].input;
        if (const auto base = (*made)[i].standsOn)
            station.tools[i].mapping = station.tools[*base].mapping;
    }
    return station;
}

tl::unexpected<core::Error> differingHands(const ExerciseKind& kind, std::size_t hands, std::size_t tools) {
    return core::fail(core::ErrorCode::wrongUse, "exercise " + std::string(kind.id()) + ": " +
                                                     std::to_string(hands) + " hands for " +
                                                     std::to_string(tools) + " instruments");
}

bool knowsItsPlace(const ExerciseKind& kind) {
    return kind.operatorsKnowTheirPlace();
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

/// The positions of a level's devices: those of the exercise, each with the chosen mounting, or else the
/// level's, relative to that position.
core::Result<std::vector<devices::WorkspaceMapping>> mountedPlaces(const ExerciseKind& kind,
                                                                   const catalogue::ExerciseLevel& level,
                                                                   const WorkspaceChoice& chosen) {
    const int tools = kind.toolCount(level);
    if (tools < 1 || tools > core::kMaxTools)
        return differingHands(kind, static_cast<std::size_t>(std::max(tools, 0)),
                              static_cast<std::size_t>(std::max(tools, 0)));
    std::vector<devices::WorkspaceMapping> places;
    for (int tool = 0; tool < tools; ++tool) {
        const auto mounted = mappingOf(mountingOf(level, tool, chosen));
        CHIRON_TRY(mounted);
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

/// The same for devices that scripted hands hold.
core::Result<std::vector<devices::WorkspaceMapping>> placesOf(const ExerciseKind& kind,
                                                              const catalogue::ExerciseLevel& level,
                                                              std::size_t hands,
                                                              const WorkspaceChoice& chosen) {
    const int tools = kind.toolCount(level);
    if (tools < 1 || tools > core::kMaxTools || hands != static_cast<std::size_t>(tools))
        return differingHands(kind, hands, static_cast<std::size_t>(std::max(tools, 0)));
    CHIRON_TRY(mappingOf(chosen));
    const WorkspaceChoice unchanged;
    const bool any = chosen.turned() || chosen.leftHanded || chosen.scale != unchanged.scale ||
                     chosen.origin_m != unchanged.origin_m;
    if (any && !kind.operatorsKnowTheirPlace())
        return core::fail(core::ErrorCode::wrongUse,
                          "exercise " + std::string(kind.id()) +
                              ": its scripted hands hold a device that stands as it is built; it can be "
                              "mounted otherwise for " +
                              idsOfKinds(knowsItsPlace));
    return mountedPlaces(kind, level, chosen);
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

/// Extends every tool's trace from the earliest to the latest time of any tool, so that all share one clock.
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

/// A pointer starts in the middle of its box, at this height.
std::optional<double> startHeightOf(const ExerciseKind& kind, const catalogue::ExerciseLevel& level,
                                    const devices::WorkspaceMapping& mapping) {
    const auto start_W = kind.toolStart_W(level, mapping);
    return start_W ? std::optional(start_W->z()) : std::nullopt;
}

core::Vec3 endoscopeStartOf(const ExerciseKind& kind, const catalogue::ExerciseLevel& level,
                            const std::vector<devices::WorkspaceMapping>& places) {
    const auto start_W =
        kind.toolStart_W(level, places.empty() ? devices::WorkspaceMapping{} : places.front());
    return start_W.value_or(core::Vec3::Zero());
}
} // namespace

core::Result<devices::WorkspaceMapping> mappingOf(const WorkspaceChoice& choice) {
    using W = WorkspaceChoice;
    if (!(choice.scale >= W::kSmallestScale && choice.scale <= W::kLargestScale))
        return core::fail(core::ErrorCode::badInput,
                          "workspace: a scale of " + std::to_string(choice.scale) + "; expected 0.25 to 4");
    for (const double shift_m : choice.origin_m) {
        if (!(std::abs(shift_m) <= W::kLargestShift_m))
            return core::fail(core::ErrorCode::badInput, "workspace: a shift of " + std::to_string(shift_m) +
                                                             " m; expected at most 0.03 m either way");
    }
    for (const double turn_rad : choice.turn_rad) {
        if (!(std::abs(turn_rad) <= W::kLargestTurn_rad + 1e-12))
            return core::fail(core::ErrorCode::badInput, "workspace: a turn of the base of " +
                                                             std::to_string(turn_rad) +
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
/// The request to a driver whose devices a person moves, without its tools.
devices::DriverRequest requestOf(const WorkspaceChoice& choice, PointerTool tool) {
    devices::DriverRequest request;
    request.shape = tool;
    request.scale = choice.scale;
    request.middle_m = choice.origin_m;
    return request;
}

/// A pointer has no mounting: each tool is at the exercise's position, with the workspace that the person
/// chose.
core::Result<std::vector<devices::WorkspaceMapping>> pointerPlaces(const ExerciseKind& kind,
                                                                   const catalogue::ExerciseLevel& level,
                                                                   const WorkspaceChoice& choice) {
    const auto chosen = mappingOf(choice);
    CHIRON_TRY(chosen);
    const int tools = kind.toolCount(level);
    if (tools < 1 || tools > core::kMaxTools)
        return differingHands(kind, static_cast<std::size_t>(std::max(tools, 0)),
                              static_cast<std::size_t>(std::max(tools, 0)));
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

std::vector<devices::WorkspaceMapping> Station::mappings() const {
    std::vector<devices::WorkspaceMapping> all;
    for (const StationTool& tool : tools)
        all.push_back(tool.mapping);
    return all;
}

bool Station::felt() const noexcept {
    return std::any_of(tools.begin(), tools.end(),
                       [](const StationTool& tool) { return tool.device->descriptor().rendersForce; });
}

std::vector<devices::PointerMailbox*> Station::pointers() const {
    std::vector<devices::PointerMailbox*> all;
    for (const StationTool& tool : tools)
        if (devices::PointerMailbox* const* mailbox = std::get_if<devices::PointerMailbox*>(&tool.input))
            all.push_back(*mailbox);
    return all;
}

devices::EndoscopeMailbox* Station::endoscope() const noexcept {
    for (const StationTool& tool : tools)
        if (devices::EndoscopeMailbox* const* mailbox = std::get_if<devices::EndoscopeMailbox*>(&tool.input))
            return *mailbox;
    return nullptr;
}

core::Result<Station> keyboardMouseStation(const WorkspaceChoice& given) {
    const WorkspaceChoice choice = ofPointer(given);
    const auto mapping = mappingOf(choice);
    CHIRON_TRY(mapping);
    devices::DriverRequest request = requestOf(choice, PointerTool::point);
    request.tools.push_back({*mapping, {}, nullptr, {}});
    return stationOf(devices::usualDriver(devices::MovedBy::person), std::move(request));
}

core::Result<Station> keyboardMouseStation(const WorkspaceChoice& given, const ExerciseKind& kind,
                                           const catalogue::ExerciseLevel& level) {
    return personStation(devices::usualDriver(devices::MovedBy::person), given, kind, level);
}

core::Result<Station> personStation(const devices::Driver& driver, const WorkspaceChoice& given,
                                    const ExerciseKind& kind, const catalogue::ExerciseLevel& level,
                                    std::span<const std::string> addresses) {
    const bool based = driver.hand == devices::HandKind::handle; // it stands somewhere
    const WorkspaceChoice choice = based ? given : ofPointer(given);
    const PointerTool tool = kind.pointerTool();
    const bool fingers = tool == PointerTool::point && kind.toolCount(level) > 1;
    std::vector<devices::WorkspaceMapping> places;
    if (based) {
        auto mounted = mountedPlaces(kind, level, choice);
        CHIRON_TRY(mounted);
        places = std::move(*mounted);
    } else if (tool == PointerTool::grasper || fingers) {
        auto several = pointerPlaces(kind, level, choice);
        CHIRON_TRY(several);
        places = std::move(*several);
    } else {
        const auto mapping = mappingOf(choice);
        CHIRON_TRY(mapping);
        places = {*mapping};
    }
    devices::DriverRequest request = requestOf(choice, tool);
    request.widestJaw_rad = tool == PointerTool::point ? kind.tools(level).widestJaw_rad : 0.0;
    request.endoscopeStart_W = endoscopeStartOf(kind, level, places);
    for (const devices::WorkspaceMapping& place : places)
        request.tools.push_back(
            {place,
             tool == PointerTool::point ? startHeightOf(kind, level, place) : std::nullopt,
             nullptr,
             {}});
    if (!addresses.empty() && addresses.size() != request.tools.size())
        return core::fail(core::ErrorCode::badInput, "addresses: " + std::to_string(addresses.size()) +
                                                         ", tools: " + std::to_string(request.tools.size()) +
                                                         "; expected one address for each tool");
    for (std::size_t i = 0; i < addresses.size(); ++i)
        request.tools[i].address = addresses[i];
    return stationOf(driver, std::move(request));
}

core::Result<Station> simulatedStation(std::string_view mechanism, SimulatedHand hand) {
    devices::DriverRequest request;
    request.mechanism = std::string(mechanism);
    request.hand = hand.hand;
    request.seed = hand.seed;
    request.frictionCompensation = hand.frictionCompensation;
    request.plant = std::move(hand.plant);
    request.tools.push_back({{}, {}, std::move(hand.strategy), {}});
    return stationOf(devices::usualDriver(devices::MovedBy::scriptedOperator), std::move(request));
}

core::Result<Station> scriptedStation(const ExerciseKind& kind, const catalogue::ExerciseLevel& level,
                                      const std::string& operatorName, std::uint64_t seed,
                                      const ScriptedDevice& held) {
    const std::span<const std::string_view> known = kind.mechanisms();
    const std::string_view chosen = held.mechanism.empty() ? kind.mechanism() : held.mechanism;
    if (std::find(known.begin(), known.end(), chosen) == known.end())
        return core::fail(core::ErrorCode::wrongUse, "mechanism \"" + std::string(chosen) + "\": exercise " +
                                                         std::string(kind.id()) + " is not done on it");
    // Hand and decision model have separate random streams, so that the same person trembles alike in another
    // field.
    const auto hands = static_cast<std::size_t>(std::max(kind.toolCount(level), 0));
    auto places = placesOf(kind, level, hands, held.mounting);
    CHIRON_TRY(places);
    auto trainee =
        kind.makeOperator(level, operatorName, core::Random::mix(seed, "operator"), {chosen, *places});
    CHIRON_TRY(trainee);
    if (trainee->strategies.size() != hands)
        return differingHands(kind, trainee->strategies.size(), hands);
    devices::DriverRequest request;
    request.shape = kind.pointerTool();
    request.endoscopeStart_W = endoscopeStartOf(kind, level, *places);
    request.mechanism = std::string(chosen);
    request.hand = held.hand != nullptr ? *held.hand : trainee->hand;
    request.seed = core::Random::mix(seed, "hand");
    request.forceMap = std::string(held.forceMap);
    request.frictionCompensation = haptics::FrictionCompensation::kMost;
    if (!devices::kinematicsOf(*held.driver, chosen))
        return core::fail(core::ErrorCode::wrongUse, "exercise " + std::string(kind.id()) +
                                                         ": no simulated mechanism \"" + std::string(chosen) +
                                                         "\"");
    const LevelTools tools = kind.tools(level);
    request.fingersPerHand = std::max(tools.perHand, 1);
    request.fingerSpacing_m = tools.spacing_m;
    for (std::size_t i = 0; i < hands; ++i)
        request.tools.push_back({(*places)[i], {}, std::move(trainee->strategies[i]), {}});
    auto station = stationOf(*held.driver, std::move(request));
    if (station)
        station->operatorName = operatorName;
    return station;
}

core::Result<Station> traceStation(const scoring::TraceRows& rows, PointerTool tool, int tools,
                                   const devices::Driver& driver) {
    const auto refuse = [&rows](const std::string& why) {
        return core::fail(core::ErrorCode::badInput, rows.source + ": " + why);
    };
    if (tool == PointerTool::endoscope && !rows.columns.orientation)
        return refuse("no orientation; an endoscope needs the columns qw, qx, qy and qz");
    if (tool == PointerTool::grasper && !rows.columns.jaw)
        return refuse("no jaw; a grasper needs the column jaw_deg");
    if (tools < 1 || tools > core::kMaxTools)
        return core::fail(core::ErrorCode::wrongUse,
                          "trace: " + std::to_string(tools) + " instruments, expected 1 to 4");
    std::vector<std::vector<devices::TracePoint>> points(static_cast<std::size_t>(tools));
    for (const scoring::TraceRow& row : rows.rows)
        if (row.tool < tools) // rows of further tools than the level has are ignored
            points[row.tool].push_back(pointOf(row, rows.columns));
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].empty())
            return refuse("no row of tool " + std::to_string(i) + "; the level needs rows of tools 0 to " +
                          std::to_string(tools - 1) + " (column tool)");
    playTogether(points);
    devices::DriverRequest request;
    request.shape = tool;
    for (std::vector<devices::TracePoint>& trace : points)
        request.tools.push_back({{}, {}, nullptr, std::move(trace)});
    auto station = stationOf(driver, std::move(request));
    if (!station)
        return refuse(station.error().message);
    station->operatorName = "trace:" + std::filesystem::path(rows.source).filename().string();
    return station;
}

} // namespace chiron::session
