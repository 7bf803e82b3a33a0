// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/site.h"

#include "database/integrity/file_health.h"
#include "devices/kinematics_catalogue.h"
#include "recording/crash_ring.h"
#include "scoring/trace_csv.h"

#include <algorithm>
#include <filesystem>

namespace chiron::session {

namespace {

core::Result<std::unique_ptr<database::Database>> createOrOpen(const std::string& file,
                                                               const database::DatabaseOptions& options) {
    std::error_code error;
    if (std::filesystem::exists(file, error)) {
        CHIRON_TRY(database::checkAtOpening(file));
        return database::Database::openForWriting(file, options);
    }
    const auto folder = std::filesystem::path(file).parent_path();
    if (!folder.empty())
        std::filesystem::create_directories(folder, error);
    if (error)
        return core::fail(core::ErrorCode::storage, folder.string() + ": cannot be made: " + error.message());
    return database::Database::create(file, options);
}

core::Result<const catalogue::ExerciseLevel*> levelOf(const catalogue::Catalogue& catalogue,
                                                      const ScriptedSession& session) {
    if (const catalogue::ExerciseLevel* level = catalogue.find(session.exercise, session.level))
        return level;
    return core::fail(core::ErrorCode::notFound,
                      "exercise \"" + session.exercise + "\": no level " + std::to_string(session.level));
}

/// The station of a session on a connected device.
core::Result<Station> connectedStation(const ExerciseKind& kind, const catalogue::ExerciseLevel& level,
                                       const ScriptedSession& session) {
    const devices::Driver* const driver = devices::findDriver(session.driver);
    if (driver == nullptr)
        return core::fail(core::ErrorCode::notFound, "device \"" + session.driver + "\": no such driver");
    if (driver->movedBy != devices::MovedBy::person || driver->hand != devices::HandKind::handle)
        return core::fail(core::ErrorCode::wrongUse,
                          "device " + session.driver + ": nobody can hold it here; it needs " +
                              (driver->movedBy == devices::MovedBy::person ? "a window" : "an operator"));
    if (!session.mechanism.empty() || !session.forceMap.empty())
        return core::fail(core::ErrorCode::wrongUse,
                          "device " + session.driver +
                              ": it has the mechanism and the force map that it states itself");
    auto station = personStation(*driver, session.mounting, kind, level, session.addresses);
    CHIRON_TRY(station);
    return station;
}

core::Result<Station> stationFor(const ExerciseKind& kind, const catalogue::ExerciseLevel& level,
                                 const ScriptedSession& session) {
    if (!session.driver.empty())
        return connectedStation(kind, level, session);
    const std::vector<std::string> names = kind.operatorNames();
    if (std::find(names.begin(), names.end(), session.operatorName) != names.end()) {
        const std::string_view mechanism =
            session.mechanism.empty() ? kind.mechanism() : std::string_view(session.mechanism);
        if (!devices::hasForceMap(devices::findKinematics(mechanism), session.forceMap))
            return core::fail(core::ErrorCode::wrongUse,
                              "force map " + session.forceMap + ": mechanism " + std::string(mechanism) +
                                  " of exercise " + session.exercise + " has no such map; expected exact");
        return scriptedStation(
            kind, level, session.operatorName, session.seed,
            {.mechanism = mechanism, .forceMap = session.forceMap, .mounting = session.mounting});
    }
    std::error_code ignored;
    if (!std::filesystem::exists(session.operatorName, ignored)) {
        std::string known;
        for (const std::string& name : names)
            known += name + ", ";
        return core::fail(core::ErrorCode::notFound, "operator \"" + session.operatorName +
                                                         "\": expected one of " + known +
                                                         "or the path of a trace file");
    }
    auto rows = scoring::readTraceCsvFile(session.operatorName);
    CHIRON_TRY(rows);
    if (!session.mechanism.empty())
        return core::fail(core::ErrorCode::wrongUse, "mechanism " + session.mechanism +
                                                         ": a trace is held by none; expected an operator");
    if (!devices::hasForceMap(nullptr, session.forceMap))
        return core::fail(core::ErrorCode::wrongUse,
                          "force map " + session.forceMap + ": a trace feels nothing; expected exact");
    if (session.mounting.turned() || session.mounting.turnGiven)
        return core::fail(core::ErrorCode::wrongUse,
                          "base turn: a trace is held by no device; expected an operator");
    return traceStation(*rows, kind.pointerTool(), kind.toolCount(level));
}

} // namespace

core::Result<OpenedSite> openSite(const std::string& file, const database::DatabaseOptions& options) {
    auto database = createOrOpen(file, options);
    CHIRON_TRY(database);
    auto recovered = recoverSessions(**database, recording::defaultRingFolder());
    CHIRON_TRY(recovered);
    return OpenedSite{std::move(*database), std::move(*recovered)};
}

core::Result<void> checkOperator(const catalogue::Catalogue& catalogue, const ScriptedSession& session) {
    auto kind = exerciseKind(session.exercise);
    CHIRON_TRY(kind);
    const auto level = levelOf(catalogue, session);
    CHIRON_TRY(level);
    auto station = stationFor(**kind, **level, session);
    CHIRON_TRY(station);
    return {};
}

core::Result<TrainingResult> runScripted(database::Database& database, const database::Actor& actor,
                                         const catalogue::Catalogue& catalogue,
                                         const ScriptedSession& session, const std::atomic<bool>* cancel) {
    auto kind = exerciseKind(session.exercise);
    CHIRON_TRY(kind);
    const auto level = levelOf(catalogue, session);
    CHIRON_TRY(level);
    auto station = stationFor(**kind, **level, session);
    CHIRON_TRY(station);
    TrainingRequest request;
    request.level = **level;
    request.seed = session.seed;
    request.station = std::move(*station);
    request.realtime = session.realtime ||
                       std::any_of(request.station.tools.begin(), request.station.tools.end(),
                                   [](const StationTool& tool) { return !tool.device->steppedByHost(); });
    request.familiarisation = session.familiarisation;
    request.cancel = cancel;
    // Nobody has logged in: it is nobody's session, and says what it was done on.
    if (!session.driver.empty() && actor.kind() == database::ActorKind::simulated)
        request.station.operatorName = "device:" + session.driver;
    return runTraining(database, actor, std::move(request));
}

} // namespace chiron::session
