// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session_output.h"

#include "catalogue/catalogue.h"
#include "database/repositories/score_repository.h"
#include "database/repositories/session_reader.h"
#include "devices/kinematics_catalogue.h"
#include "report/report_text.h"
#include "session/exercise_kind.h"
#include "session/person_json.h"
#include "session/session_setup.h"
#include "session/yield_cause.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <cmath>
#include <cstdio>

namespace chiron::cli {

namespace {

QString text(const std::string& words) {
    return QString::fromStdString(words);
}

QJsonObject parsed(const std::string& json) {
    return QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
}

/// The devices of the session, one entry per tool: driver, model, and how force was converted to efforts
/// where there is a choice.
QJsonArray devicesJson(const database::SessionRecord& record) {
    QJsonArray list;
    const auto setup = session::setupFromStored(record.setup);
    if (!setup)
        return list; // the set-up has another version; everything else is still shown
    for (std::size_t tool = 0; tool < setup->devices.size(); ++tool) {
        const devices::DeviceDescriptor& device = setup->devices[tool];
        QJsonObject entry{{"driver", text(device.driver)},
                          {"model", text(device.model)},
                          {"kinematics", text(device.kinematics)}};
        if (!device.serialNumber.empty())
            entry.insert("serial_number", text(device.serialNumber));
        if (const devices::KinematicsEntry* kinematics = devices::findKinematics(device.kinematics);
            kinematics && kinematics->forceMaps)
            entry.insert("force_map", text(std::string(kinematics->forceMaps->of(device))));
        if (const devices::WorkspaceMapping& mapping = setup->mappings[tool]; mapping.turned())
            entry.insert("base_turn", QJsonArray{mapping.q_WD[0], mapping.q_WD[1], mapping.q_WD[2],
                                                 mapping.q_WD[3]}); // w, x, y, z
        list.append(entry);
    }
    return list;
}

/// The quantity to which the tissue gave way.
QJsonObject causeJson(const simulation::YieldLaw& law, const database::EventRecord& event) {
    const session::YieldCause cause = session::yieldCauseOf(law, event.detailJson);
    return {{"quantity", cause.byTorque ? "torque" : "force"},
            {"value", cause.value},
            {"unit", cause.byTorque ? "mN·m" : "N"}};
}

} // namespace

core::Result<ScoreView> viewOf(database::Connection& connection, const database::Actor& actor,
                               database::SessionId session) {
    auto record = database::SessionReader(connection, actor).session(session);
    CHIRON_TRY(record);
    ScoreView view;
    view.sessionId = session;
    const std::string_view state = database::token(record->summary.state);
    view.state = QString::fromUtf8(state.data(), qsizetype(state.size()));
    view.loop = parsed(record->loopJson);
    view.recording = {{"frames", static_cast<double>(record->summary.frames)},
                      {"dropped", static_cast<double>(record->summary.dropped)},
                      {"bytes", static_cast<double>(record->summary.recordingBytes)}};
    auto card = database::ScoreRepository(connection, actor).scores(session);
    if (!core::failedAs(card, core::ErrorCode::notFound))
        CHIRON_TRY(card);
    if (card)
        view.card = std::move(*card);
    auto trials = database::SessionReader(connection, actor).trials(session);
    CHIRON_TRY(trials);
    const auto setup = session::setupFromStored(record->setup);
    const bool leavesOut = setup && setup->scoring == session::ScoringRule::finishedTrials;
    for (const database::TrialRecord& trial : *trials) {
        const std::string_view ended = database::token(trial.state);
        view.trials.push_back({QString::fromUtf8(ended.data(), qsizetype(ended.size())), trial.marked,
                               trial.timedOut, parsed(trial.sceneJson)["failed"].toBool(),
                               leavesOut && trial.state != database::SessionState::completed});
    }
    return view;
}

QJsonObject summaryJson(const database::SessionSummary& summary) {
    const std::string_view state = database::token(summary.state);
    return {
        {"session_id", static_cast<double>(summary.id)},
        {"person", text(summary.personName)},
        {"exercise", text(summary.exercise)},
        {"level", summary.level},
        {"attempt", summary.attempt > 0 ? QJsonValue(summary.attempt) : QJsonValue()},
        {"operator", text(summary.operatorName)},
        {"state", QString::fromUtf8(state.data(), qsizetype(state.size()))},
        {"passed", summary.passed ? QJsonValue(*summary.passed) : QJsonValue()},
        {"started_utc", text(summary.startedUtc)},
        {"utc_offset_min", summary.utcOffset_min},
        {"device_class", summary.felt ? "felt" : "shown"},
        {"familiarisation", summary.familiarisation},
        {"demonstration", summary.demonstration},
        {"archived", summary.archived},
        {"sealed", summary.sealed},
        {"frames", summary.sealed ? QJsonValue() : QJsonValue(static_cast<double>(summary.frames))},
        {"bytes", summary.sealed ? QJsonValue() : QJsonValue(static_cast<double>(summary.recordingBytes))}};
}

QJsonObject sessionJson(const ScoreView& view, const database::SessionRecord& record) {
    QJsonObject json = scoreJson(view);
    const QJsonObject summary = summaryJson(record.summary);
    for (auto it = summary.begin(); it != summary.end(); ++it) {
        if (!json.contains(it.key()))
            json.insert(it.key(), it.value());
    }
    // A text, because JSON numbers lose digits of large seeds.
    json.insert("seed", text(std::to_string(record.setup.seed)));
    json.insert("content_sha256", text(record.contentSha256));
    json.insert("task_sha256", text(catalogue::taskSha256(record.setup.contentJson)));
    json.insert("build", text(record.setup.buildId));
    json.insert("cpu_class", text(record.setup.cpuClass));
    json.insert("devices", devicesJson(record));
    if (!record.voidReason.empty())
        json.insert("void_reason", text(record.voidReason));
    if (!record.decisions.empty())
        json.insert("decisions", session::decisionsJson(record.decisions));
    return json;
}

core::Result<QJsonArray> eventsJson(database::Connection& connection, const database::Actor& actor,
                                    const database::SessionRecord& record) {
    auto events = database::SessionReader(connection, actor).events(record.summary.id);
    CHIRON_TRY(events);
    const auto setup = session::setupFromStored(record.setup);
    QJsonArray array;
    for (const database::EventRecord& event : *events) {
        QJsonObject json{{"tick", static_cast<double>(event.tick)},
                         {"time_s", event.time_s},
                         {"tool", event.tool},
                         {"kind", text(event.kind)},
                         {"detail", parsed(event.detailJson)}};
        // In a set-up of another version, the level is not known.
        if (event.kind == "tissue_yielded" && setup)
            json.insert("gave_way_to", causeJson(session::yieldLawOf(setup->level), event));
        array.append(json);
    }
    return array;
}

QJsonArray yieldsOf(const QJsonArray& events) {
    QJsonArray yields;
    for (const QJsonValue event : events)
        if (event["kind"].toString() == QLatin1String("tissue_yielded")) {
            QJsonObject json{{"trial", event["detail"]["trial"].toInt() + 1},
                             {"tool", event["tool"]},
                             {"time_s", event["time_s"]}};
            if (!event["gave_way_to"].isUndefined())
                json.insert("gave_way_to", event["gave_way_to"]);
            // Sessions of earlier versions do not say where.
            if (const QJsonValue place = event["detail"]["position_m"]; place.isArray())
                json.insert("position_m", place);
            yields.append(json);
        }
    return yields;
}

/// Metres as millimetres with one decimal; what rounds to nothing has no sign.
static QString millimetres(double value_m) {
    return QString::number(std::round(1e4 * value_m) / 10.0 + 0.0, 'f', 1);
}

QString yieldsText(const QJsonArray& yields, std::string_view exercise) {
    const std::string_view words = session::yieldWords(exercise);
    const QString what = QString::fromUtf8(words.data(), qsizetype(words.size()));
    QString lines;
    for (const QJsonValue yield : yields) {
        const QJsonValue cause = yield["gave_way_to"];
        lines += QStringLiteral("%1: trial %2, tool %3, at %4 s")
                     .arg(what)
                     .arg(yield["trial"].toInt())
                     .arg(yield["tool"].toInt() + 1)
                     .arg(yield["time_s"].toDouble(), 0, 'f', 3);
        if (!cause.isUndefined())
            lines += QStringLiteral(", %1 %2 %3")
                         .arg(cause["quantity"].toString(),
                              report::formatNumber(cause["value"].toDouble(), QLocale::c()),
                              cause["unit"].toString());
        if (const QJsonArray place = yield["position_m"].toArray(); place.size() == 3)
            lines += QStringLiteral(", tip at x %1, y %2, z %3 mm")
                         .arg(millimetres(place[0].toDouble()), millimetres(place[1].toDouble()),
                              millimetres(place[2].toDouble()));
        lines += QLatin1Char('\n');
    }
    return lines.isEmpty() ? lines : QLatin1Char('\n') + lines;
}

QString decisionsText(const std::vector<database::SessionDecision>& decisions) {
    QString lines;
    for (const database::SessionDecision& decision : decisions)
        lines += QStringLiteral("%1 on %2 by person %3: %4\n")
                     .arg(decision.voiding ? QStringLiteral("voided") : QStringLiteral("counted again"),
                          text(decision.utc))
                     .arg(decision.person)
                     .arg(decision.reason.empty() ? QStringLiteral("(erased)") : text(decision.reason));
    return lines.isEmpty() ? lines : QLatin1Char('\n') + lines;
}

void tell(const QString& line) {
    const QByteArray bytes = (line + QLatin1Char('\n')).toUtf8();
    std::fwrite(bytes.constData(), 1, static_cast<std::size_t>(bytes.size()), stderr);
}

} // namespace chiron::cli
