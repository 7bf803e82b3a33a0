// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session_setup.h"

#include "catalogue/catalogue.h"
#include "core/fp_environment.h"
#include "core/random.h"
#include "session/device_json.h"
#include "session/exercise_kind.h"
#include "session/safety_json.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>

namespace chiron::session {

namespace {

std::string compact(const QJsonObject& object) {
    return QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString(); // QJsonObject sorts its keys
}

core::Result<QJsonObject> parse(const std::string& text, const char* column) {
    QJsonParseError error{};
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(text), &error);
    if (!document.isObject())
        return core::fail(core::ErrorCode::badInput, std::string("session column ") + column +
                                                         ": expected a JSON object (" +
                                                         error.errorString().toStdString() + ")");
    return document.object();
}

template <class T> std::string toolsJson(const std::vector<T>& items) {
    QJsonArray tools;
    for (const T& item : items)
        tools.append(toJson(item));
    return compact({{"tools", tools}});
}

template <class T, class Read>
core::Result<std::vector<T>> toolsFromJson(const std::string& text, const char* column, Read read) {
    auto object = parse(text, column);
    CHIRON_TRY(object);
    std::vector<T> items;
    for (const QJsonValue& value : object->value(QLatin1String("tools")).toArray()) {
        auto item = read(value.toObject());
        CHIRON_TRY(item);
        items.push_back(std::move(*item));
    }
    if (items.empty() || items.size() > core::kMaxTools)
        return core::fail(core::ErrorCode::badInput,
                          std::string("session column ") + column + ".tools: expected 1 to 4 tools");
    return items;
}

std::string versionsJson(const catalogue::ExerciseLevel& level, ScoringRule scoring) {
    QJsonObject metrics;
    for (const auto& metric : level.metrics)
        metrics.insert(QString::fromStdString(metric.id), metric.version);
    return compact(
        {{"exercise", level.exerciseVersion},
         {"metrics", metrics},
         {"scoring", static_cast<int>(scoring)},
         {"random", QString::fromUtf8(core::Random::kName.data(), qsizetype(core::Random::kName.size()))}});
}

core::Result<ScoringRule> scoringFromJson(const std::string& text) {
    const auto versions = parse(text.empty() ? "{}" : text, "versions");
    CHIRON_TRY(versions);
    const QJsonValue rule = versions->value(QLatin1String("scoring"));
    if (rule.isUndefined())
        return ScoringRule::begunTrials;
    const int number = rule.toInt(0);
    if (number != static_cast<int>(ScoringRule::begunTrials) &&
        number != static_cast<int>(ScoringRule::finishedTrials))
        return core::fail(
            core::ErrorCode::badInput,
            "session column versions.scoring: expected 1 or 2; a newer version of this program may know it");
    return static_cast<ScoringRule>(number);
}

} // namespace

bool SessionSetup::felt() const {
    return std::any_of(devices.begin(), devices.end(), [](const auto& d) { return d.rendersForce; });
}

database::NewSession toNewSession(const SessionSetup& setup) {
    database::NewSession session;
    session.exercise = setup.level.exercise;
    session.level = setup.level.number;
    session.contentJson = setup.level.resolvedJson;
    session.seed = setup.seed;
    session.felt = setup.felt();
    session.deviceJson = toolsJson(setup.devices);
    session.mappingJson = toolsJson(setup.mappings);
    session.supervisorJson = compact(toJson(setup.safety));
    session.versionsJson = versionsJson(setup.level, setup.scoring);
    session.buildId = core::buildId();
    session.cpuClass = core::cpuClass();
    if (const auto kind = exerciseKind(setup.level.exercise)) {
        session.forceLimit_N = (*kind)->forceLimit_N(setup.level);
        session.plannedTrials = (*kind)->trialCount(setup.level);
    }
    return session;
}

core::Result<SessionSetup> setupFromStored(const database::NewSession& stored) {
    SessionSetup setup;
    auto level = catalogue::fromResolvedJson(stored.contentJson);
    CHIRON_TRY(level);
    setup.level = std::move(*level);
    setup.seed = stored.seed;
    auto devices = toolsFromJson<devices::DeviceDescriptor>(stored.deviceJson, "device", descriptorFromJson);
    CHIRON_TRY(devices);
    auto mappings = toolsFromJson<devices::WorkspaceMapping>(stored.mappingJson, "mapping", mappingFromJson);
    CHIRON_TRY(mappings);
    auto supervisor = parse(stored.supervisorJson, "supervisor");
    CHIRON_TRY(supervisor);
    auto safety = safetyFromJson(*supervisor);
    CHIRON_TRY(safety);
    if (devices->size() != mappings->size())
        return core::fail(core::ErrorCode::badInput, "session: devices and mappings differ in number");
    const auto scoring = scoringFromJson(stored.versionsJson);
    CHIRON_TRY(scoring);
    setup.scoring = *scoring;
    setup.devices = std::move(*devices);
    setup.mappings = std::move(*mappings);
    setup.safety = *safety;
    return setup;
}

} // namespace chiron::session
