// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_errors.h"
#include "cli/command_groups.h"
#include "cli/session_output.h"
#include "cli/site_access.h"
#include "core/units.h"
#include "database/accounts/account_service.h"
#include "devices/driver_catalogue.h"
#include "devices/kinematics_catalogue.h"
#include "session/exercise_kind.h"
#include "session/site.h"

#include <QJsonArray>
#include <array>
#include <atomic>
#include <cmath>
#include <csignal>

namespace chiron::cli {

namespace {

std::atomic<bool> g_cancel{false}; // the only object that the signal handler may touch

void onSignal(int) {
    g_cancel.store(true, std::memory_order_relaxed);
}

core::Result<database::Actor> actorFor(const Arguments& arguments, database::Database& database,
                                       const std::vector<std::string>& secrets) {
    if (!arguments.has(QStringLiteral("as")))
        return database::Actor::simulated(); // may create and read simulated sessions only
    return database::AccountService(database).login(arguments.value(QStringLiteral("as")).toStdString(),
                                                    secrets[0]);
}

/// --base-turn H,T,R in degrees.
core::Result<std::array<double, 3>> baseTurnOf(const Arguments& arguments) {
    std::array<double, 3> turn_rad{};
    if (!arguments.has(QStringLiteral("base-turn")))
        return turn_rad;
    const QString given = arguments.value(QStringLiteral("base-turn"));
    const QStringList parts = given.split(QLatin1Char(','));
    bool right = parts.size() == 3;
    for (int i = 0; right && i < 3; ++i) {
        const double degrees = parts[i].toDouble(&right);
        right = right && std::abs(degrees) <= 45.0;
        turn_rad[static_cast<std::size_t>(i)] = core::radFromDeg(degrees);
    }
    if (!right)
        return badInput(QStringLiteral("--base-turn %1: expected three angles in degrees, -45 to 45, as "
                                       "10,0,-5: to the left, away, to the right")
                            .arg(quoted(given)));
    return turn_rad;
}

/// Who or what moves the tools: a scripted operator, a trace, or whoever holds a device that is connected.
core::Result<void> takeMover(const Arguments& arguments, session::ScriptedSession& asked) {
    const bool held = arguments.has(QStringLiteral("device"));
    if (held == arguments.has(QStringLiteral("operator")))
        return wrongUse(held ? QStringLiteral("--operator and --device: expected one of them: whoever holds "
                                              "the device moves it")
                             : QStringLiteral("--operator is missing; expected --operator NAME|TRACE.csv, or "
                                              "--device ID; see chiron-cli train --help"));
    asked.operatorName = arguments.value(QStringLiteral("operator")).toStdString();
    if (!held) {
        if (arguments.has(QStringLiteral("address")))
            return wrongUse(QStringLiteral("--address: means nothing without --device"));
        return {};
    }
    asked.driver = arguments.value(QStringLiteral("device")).toStdString();
    if (devices::findDriver(asked.driver) == nullptr)
        return wrongUse(QStringLiteral("--device: %1: unknown; see chiron-cli device list")
                            .arg(quoted(arguments.value(QStringLiteral("device")))));
    for (const QString& address :
         arguments.value(QStringLiteral("address")).split(QLatin1Char(','), Qt::SkipEmptyParts))
        asked.addresses.push_back(address.toStdString());
    for (const char* option : {"force-map", "mechanism"})
        if (arguments.has(QLatin1String(option)))
            return wrongUse(
                QStringLiteral("--%1: the device states its own; expected it with --operator alone")
                    .arg(QLatin1String(option)));
    return {};
}

core::Result<std::vector<session::ScriptedSession>> plan(const Arguments& arguments,
                                                         const catalogue::Catalogue& catalogue) {
    session::ScriptedSession asked;
    asked.exercise = arguments.operand(0).toStdString();
    const catalogue::Exercise* exercise = catalogue.find(asked.exercise);
    if (!exercise)
        return badInput(QStringLiteral("EXERCISE %1: unknown; see chiron-cli exercise list")
                            .arg(quoted(arguments.operand(0))));
    CHIRON_TRY(takeMover(arguments, asked));
    auto seed = arguments.seed(QStringLiteral("seed"), 1);
    CHIRON_TRY(seed);
    asked.seed = *seed;
    asked.realtime = arguments.has(QStringLiteral("realtime"));
    asked.familiarisation = arguments.has(QStringLiteral("familiarisation"));
    QStringList maps;
    for (const std::string_view id : devices::forceMapIds())
        maps << QString::fromUtf8(id.data(), static_cast<qsizetype>(id.size()));
    const auto map = arguments.choice(QStringLiteral("force-map"), maps, maps.front());
    CHIRON_TRY(map);
    asked.forceMap = asked.driver.empty() ? map->toStdString() : std::string();
    asked.mechanism = arguments.value(QStringLiteral("mechanism")).toStdString();
    auto turn = baseTurnOf(arguments);
    CHIRON_TRY(turn);
    asked.mounting.turn_rad = *turn;
    asked.mounting.turnGiven = arguments.has(QStringLiteral("base-turn"));
    std::vector<session::ScriptedSession> sessions;
    const int levels = static_cast<int>(exercise->levels.size());
    const bool all = arguments.value(QStringLiteral("level")) == QLatin1String("all");
    auto level = all ? core::Result<qint64>(1) : arguments.integer(QStringLiteral("level"), 1, levels, 1);
    CHIRON_TRY(level);
    for (int number = all ? 1 : static_cast<int>(*level); number <= (all ? levels : static_cast<int>(*level));
         ++number) {
        asked.level = number;
        CHIRON_TRY(session::checkOperator(catalogue, asked));
        sessions.push_back(asked);
    }
    return sessions;
}

core::Result<std::vector<ScoreView>> runAll(session::OpenedSite& site, const database::Actor& actor,
                                            const catalogue::Catalogue& catalogue,
                                            const std::vector<session::ScriptedSession>& sessions) {
    std::vector<ScoreView> views;
    for (const session::ScriptedSession& session : sessions) {
        auto result = session::runScripted(*site.database, actor, catalogue, session, &g_cancel);
        CHIRON_TRY(result);
        if (result->loop.realtime && !result->loop.priorityGranted)
            tell(QStringLiteral("no real-time priority: %1")
                     .arg(QString::fromStdString(result->loop.priorityDetail)));
        auto connection = site.database->openReader();
        CHIRON_TRY(connection);
        auto view = viewOf(**connection, actor, result->session);
        CHIRON_TRY(view);
        views.push_back(std::move(*view));
        if (g_cancel.load())
            break;
    }
    return views;
}

bool hasSeveralMechanisms(const session::ExerciseKind& kind) {
    return kind.mechanisms().size() > 1;
}

/// Kinematics ids of the mechanisms among which exercises leave a choice, as "a or b".
QString mechanismsToChoose() {
    QStringList ids;
    for (const session::ExerciseKind* kind : session::exerciseKinds())
        if (hasSeveralMechanisms(*kind))
            for (const std::string_view mechanism : kind->mechanisms())
                ids << QString::fromUtf8(mechanism.data(), static_cast<qsizetype>(mechanism.size()));
    ids.removeDuplicates();
    return ids.join(QStringLiteral(" or "));
}

core::Result<CommandOutput> train(const Arguments& arguments) {
    std::vector<std::string> secrets;
    if (arguments.has(QStringLiteral("as"))) {
        auto read = readSecrets(arguments, {QStringLiteral("CHIRON_PASSWORD")});
        CHIRON_TRY(read);
        secrets = std::move(*read);
    }
    auto content = catalogue::findContentDirectory();
    CHIRON_TRY(content);
    auto catalogue = catalogue::Catalogue::load(*content);
    CHIRON_TRY(catalogue);
    auto sessions = plan(arguments, *catalogue);
    CHIRON_TRY(sessions);
    auto site = session::openSite(databasePath(arguments).toStdString(), databaseOptions());
    CHIRON_TRY(site);
    for (const session::RecoveredSession& recovered : site->recovered) {
        tell(recovered.sealed
                 ? QStringLiteral(
                       "session %1 was interrupted; what it holds is told once its study is unblinded")
                       .arg(recovered.session)
                 : QStringLiteral("session %1 was interrupted; %2 frames are kept")
                       .arg(recovered.session)
                       .arg(recovered.frames));
        if (!recovered.problem.empty())
            tell(QStringLiteral("session %1 could not be recovered wholly: %2")
                     .arg(recovered.session)
                     .arg(QString::fromStdString(recovered.problem)));
    }
    auto actor = actorFor(arguments, *site->database, secrets);
    CHIRON_TRY(actor);
    std::signal(SIGINT, onSignal);
    std::signal(SIGTERM, onSignal);
    auto views = runAll(*site, *actor, *catalogue, *sessions);
    CHIRON_TRY(views);
    QString text;
    QJsonArray list;
    for (const ScoreView& view : *views) {
        text += scoreText(view) + QLatin1Char('\n');
        list.append(scoreJson(view));
    }
    const bool one = sessions->size() == 1;
    return CommandOutput{QJsonDocument(one ? list.at(0).toObject() : QJsonObject{{"sessions", list}}), text,
                         0};
}

} // namespace

std::vector<CommandSpec> trainCommands() {
    const auto kindsWith = [](bool (*holds)(const session::ExerciseKind&)) {
        return QString::fromStdString(session::idsOfKinds(holds));
    };
    CommandSpec command;
    command.group = QStringLiteral("train");
    command.summary =
        QStringLiteral("run one session with a scripted hand, a trace or a device; recorded and scored");
    command.operands = {{QStringLiteral("EXERCISE"), QStringLiteral("id of an exercise, see exercise list")}};
    command.options = {
        {QStringLiteral("level"), QStringLiteral("N|all"), QStringLiteral("which level; default: 1")},
        {QStringLiteral("operator"), QStringLiteral("NAME|TRACE.csv"),
         QStringLiteral("novice, intermediate, expert, unsafe, or a trace file")},
        {QStringLiteral("device"), QStringLiteral("ID"),
         QStringLiteral("instead of an operator: a connected device that somebody holds, see device list; by "
                        "its clock; with --as it is that person's session")},
        {QStringLiteral("address"), QStringLiteral("ADDRESS"),
         QStringLiteral("with --device: where it is connected, one for each tool, separated by commas: "
                        "tcp:HOST:PORT, serial:/dev/NAME or hid:VVVV:PPPP[:SERIAL]")},
        {QStringLiteral("seed"), QStringLiteral("S"), QStringLiteral("of scene and hand; default: 1")},
        {QStringLiteral("realtime"),
         {},
         QStringLiteral("at 1 kHz by the clock; default: as fast as the machine can, same result")},
        {QStringLiteral("familiarisation"), {}, QStringLiteral("recorded and marked, never counted")},
        {QStringLiteral("force-map"), QStringLiteral("WORD"),
         QStringLiteral("how the simulated gimbal makes torques of a force: exact (power is conserved) or "
                        "as-published; default: exact")},
        {QStringLiteral("base-turn"), QStringLiteral("H,T,R"),
         QStringLiteral("how the device's base is mounted, in degrees: turned to the left, tilted away, "
                        "rolled to the right (%1); default: 0,0,0")
             .arg(kindsWith(
                 [](const session::ExerciseKind& kind) { return kind.operatorsKnowTheirPlace(); }))},
        {QStringLiteral("mechanism"), QStringLiteral("ID"),
         QStringLiteral("what the scripted hand holds: %1 (%2); default: the exercise's usual one")
             .arg(mechanismsToChoose(), kindsWith(hasSeveralMechanisms))}};
    command.example =
        QStringLiteral("chiron-cli train sphere_apex --level 2 --operator expert --seed 7 --json");
    command.run = train;
    return {command};
}

} // namespace chiron::cli
