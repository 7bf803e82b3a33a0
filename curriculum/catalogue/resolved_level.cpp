// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/resolved_level.h"

#include "catalogue/canonical_json.h"
#include "catalogue/catalogue.h"
#include "catalogue/exercise_contents.h"
#include "catalogue/json_file.h"
#include "catalogue/object_reader.h"
#include "core/units.h"

#include <QJsonDocument>
#include <initializer_list>

namespace chiron::catalogue {

namespace {

constexpr int kFormat = 1; ///< format of the resolved document; raise it when a key changes its meaning

void readMetricsAndGates(const ObjectReader& json, ExerciseLevel& level) {
    json.eachObject("metrics", [&](const ObjectReader& metric) {
        level.metrics.push_back({metric.text("id"), metric.integer("version")});
    });
    json.eachObject("gates", [&](const ObjectReader& gate) {
        scoring::Gate out;
        out.metric = gate.text("metric");
        if (gate.has("minimum"))
            out.minimum = gate.number("minimum");
        if (gate.has("maximum"))
            out.maximum = gate.number("maximum");
        level.gates.push_back(std::move(out));
    });
}

core::BaseMounting readMounting(const ObjectReader& json) {
    core::BaseMounting base;
    base.scale = json.number("scale");
    base.origin_m = {core::mFromMm(json.number("shift_x_mm")), core::mFromMm(json.number("shift_y_mm")),
                     core::mFromMm(json.number("shift_z_mm"))};
    base.leftHanded = json.boolean("mirrored");
    base.turn_rad = {core::radFromDeg(json.number("turn_deg")), core::radFromDeg(json.number("tilt_deg")),
                     core::radFromDeg(json.number("roll_deg"))};
    return base;
}

} // namespace

QJsonObject resolvedDocument(const QJsonObject& exercise, const QJsonObject& level) {
    return {{"format", kFormat}, {"exercise", exercise}, {"level", level}};
}

QJsonObject withoutTexts(QJsonObject document) {
    const auto drop = [](QJsonObject& from, const char* member, std::initializer_list<const char*> texts) {
        QJsonObject part = from[QLatin1String(member)].toObject();
        for (const char* key : texts)
            part.remove(QLatin1String(key));
        if (from.contains(QLatin1String(member)))
            from[QLatin1String(member)] = part;
    };
    drop(document, "exercise", {"title", "objective", "advice", "legend"});
    QJsonObject level = document[QLatin1String("level")].toObject();
    drop(level, "shown_force_variant", {"note"});
    document[QLatin1String("level")] = level;
    drop(document, "level", {"title", "goal", "objective", "measured"});
    return document;
}

std::string taskSha256(std::string_view resolvedJson) {
    const QJsonObject document =
        QJsonDocument::fromJson(QByteArray(resolvedJson.data(), static_cast<qsizetype>(resolvedJson.size())))
            .object();
    return document[QLatin1String("level")].isObject() ? sha256Hex(canonicalJson(withoutTexts(document)))
                                                       : std::string();
}

ExerciseLevel levelFromResolved(const QJsonObject& document, Problems& problems) {
    ExerciseLevel level;
    const ObjectReader root(document, QStringLiteral("$"), problems);
    if (root.integer("format") != kFormat)
        problems.push_back({QStringLiteral("$.format"), QString::number(document["format"].toInt()),
                            QStringLiteral("%1, the format this program knows").arg(kFormat)});
    const ObjectReader exercise = root.object("exercise");
    level.exercise = exercise.text("id");
    level.exerciseVersion = exercise.integer("version");
    const ObjectReader json(root.object("level").json(), QStringLiteral("$"), problems);
    level.id = json.text("id");
    level.number = json.integer("number");
    level.title = json.translated("title");
    if (json.has("goal"))
        level.goal = json.translated("goal");
    level.objective = json.translated("objective");
    level.measured = json.translated("measured");
    level.cues = json.texts("cues");
    level.feedback = json.has("feedback") && json.boolean("feedback");
    level.needsForce = json.boolean("needs_force");
    if (json.has("shown_force_variant")) {
        const ObjectReader shown = json.object("shown_force_variant");
        level.shownForce = ShownForceVariant{shown.texts("cues"), shown.translated("note")};
    }
    if (json.has("mounting"))
        json.eachObject("mounting",
                        [&](const ObjectReader& base) { level.mounting.push_back(readMounting(base)); });
    readMetricsAndGates(json, level);
    if (const ExerciseContent* content = findExerciseContent(level.exercise))
        level.parameters = content->read(json.object("parameters"), level.cues);
    else
        problems.push_back({QStringLiteral("$.exercise.id"), quoted(QString::fromStdString(level.exercise)),
                            QStringLiteral("an exercise this program knows")});
    level.resolvedJson = canonicalJson(document);
    level.resolvedSha256 = sha256Hex(level.resolvedJson);
    return level;
}

core::Result<ExerciseLevel> fromResolvedJson(std::string_view json) {
    const QByteArray bytes(json.data(), static_cast<qsizetype>(json.size()));
    const auto file = JsonFile::parse(bytes, QStringLiteral("stored content"), JsonFile::kMeshMebibytes);
    CHIRON_TRY(file);
    Problems problems;
    ExerciseLevel level = levelFromResolved(file->root(), problems);
    if (!problems.empty())
        return tl::unexpected(file->error(problems));
    level.resolvedJson = json;
    level.resolvedSha256 = sha256Hex(level.resolvedJson);
    return level;
}

core::Result<ExerciseLevel> withTrials(const ExerciseLevel& level, int most) {
    const auto file = JsonFile::parse(QByteArray::fromStdString(level.resolvedJson), QStringLiteral("level"),
                                      JsonFile::kMeshMebibytes);
    CHIRON_TRY(file);
    QJsonObject document = file->root();
    QJsonObject inner = document["level"].toObject();
    QJsonObject parameters = inner["parameters"].toObject();
    if (!parameters.contains("trials") || parameters["trials"].toInt() <= most || most < 1)
        return level;
    parameters["trials"] = most;
    inner["parameters"] = parameters;
    document["level"] = inner;
    return fromResolvedJson(canonicalJson(document));
}

} // namespace chiron::catalogue
