// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/content_reader.h"

#include "catalogue/exercise_contents.h"
#include "catalogue/level_checks.h"
#include "catalogue/resolved_level.h"
#include "scoring/metric_catalogue.h"

#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>
#include <QStringList>
#include <algorithm>

namespace chiron::catalogue {

namespace {

core::Result<void> checkNumbers(const std::vector<ExerciseLevel>& levels, const QString& folder) {
    for (std::size_t i = 0; i < levels.size(); ++i)
        if (levels[i].number != static_cast<int>(i) + 1)
            return core::fail(
                core::ErrorCode::badInput,
                QStringLiteral("%1/levels/%2.json: $.number: %3: expected %4: levels are numbered from 1, "
                               "each number once, none left out")
                    .arg(folder, QString::fromStdString(levels[i].id))
                    .arg(levels[i].number)
                    .arg(i + 1)
                    .toStdString());
    if (levels.empty())
        return core::fail(core::ErrorCode::badInput,
                          (folder + "/levels: no level: expected at least one").toStdString());
    return {};
}

void checkName(const QJsonObject& json, const QString& expected, Problems& problems) {
    if (json["id"].toString() != expected)
        problems.push_back({QStringLiteral("$.id"), quoted(json["id"].toString()),
                            QStringLiteral("the name of its file or folder, %1").arg(quoted(expected))});
}

/// Reads the sentence on the moment at which a metric was worst; empty if there is none. Its places in every
/// language are those that a debrief fills in, and those of the text in English.
Translated momentOf(const ObjectReader& entry) {
    if (!entry.has("moment"))
        return {};
    const auto placesIn = [](const std::string& text) {
        QStringList places;
        static const QRegularExpression kPlace(QStringLiteral("\\{[^}]*\\}?"));
        for (auto found = kPlace.globalMatch(QString::fromStdString(text)); found.hasNext();)
            places << found.next().captured();
        places.sort();
        return places;
    };
    const Translated moment = entry.translated("moment");
    Problems& problems = entry.problems();
    const QString at = memberPath(entry.path(), QStringLiteral("moment"));
    const QStringList known{QLatin1String(kMomentValue), QLatin1String(kMomentEvent),
                            QLatin1String(kMomentWhere)};
    const QStringList ofSource = placesIn(textIn(moment, "en"));
    for (const QString& place : ofSource)
        if (!known.contains(place) || ofSource.count(place) > 1)
            problems.push_back({at, quoted(place),
                                QStringLiteral("each at most once of ") + known.join(QStringLiteral(", "))});
    if (!ofSource.contains(QLatin1String(kMomentWhere)))
        problems.push_back({at, QStringLiteral("no place for where it was"),
                            QStringLiteral("a text with ") + QLatin1String(kMomentWhere)});
    for (const auto& [language, text] : moment)
        if (const QStringList places = placesIn(text); places != ofSource)
            problems.push_back(
                {memberPath(at, QString::fromStdString(language)), quoted(places.join(QStringLiteral(" "))),
                 QStringLiteral("the same places as in English: ") + ofSource.join(QStringLiteral(" "))});
    return moment;
}

/// Returns the name of the parameter that names a preset.
QString presetKeyOf(const ExerciseContent& content) {
    return QString::fromUtf8(content.presetKey.data(), static_cast<qsizetype>(content.presetKey.size()));
}

} // namespace

core::Result<const Schema*> ContentReader::schema(const QString& name) {
    if (const auto known = m_schemas.find(name); known != m_schemas.end())
        return &known->second;
    auto read = readSchema(m_directory + "/schema", name);
    CHIRON_TRY(read);
    return &m_schemas.emplace(name, std::move(*read)).first->second;
}

core::Result<QJsonObject> ContentReader::withPreset(const QString& folder, const ExerciseContent& content,
                                                    const Schema& parameterSchema, const QJsonObject& given,
                                                    Problems& problems) {
    const QString key = presetKeyOf(content);
    const QString name = given.contains(key) ? given[key].toString()
                                             : parameterSchema.properties.at(key)->defaultValue.toString();
    if (given.contains(key) && !given[key].isString())
        return given; // refused by its own schema
    QStringList known = QDir(folder).entryList({"*.json"}, QDir::Files, QDir::Name);
    known.replaceInStrings(QStringLiteral(".json"), QString());
    if (!known.contains(name)) {
        problems.push_back({memberPath(QStringLiteral("$.parameters"), key), quoted(name),
                            QStringLiteral("a preset of the exercise: ") + known.join(QStringLiteral(", ")) +
                                didYouMean(name, {known.begin(), known.end()})});
        return given;
    }
    auto preset =
        presetParameters(QDir(folder).filePath(name + QStringLiteral(".json")), key, parameterSchema);
    CHIRON_TRY(preset);
    for (auto it = given.begin(); it != given.end(); ++it)
        preset->insert(it.key(), it.value());
    return preset;
}

core::Result<void> ContentReader::checkPresets(const QString& folder, const ExerciseContent& content,
                                               ContentTexts& texts) {
    if (content.presetKey.empty())
        return {};
    const auto parameterSchema = schema(QString::fromUtf8(content.parametersSchema.data()));
    CHIRON_TRY(parameterSchema);
    for (const QFileInfo& file : QDir(folder).entryInfoList({"*.json"}, QDir::Files, QDir::Name))
        CHIRON_TRY(presetParameters(file.filePath(), presetKeyOf(content), **parameterSchema, &texts));
    return {};
}

core::Result<QJsonObject> ContentReader::presetParameters(const QString& path, const QString& key,
                                                          const Schema& parameterSchema,
                                                          ContentTexts* texts) {
    const auto json = JsonFile::read(QDir::cleanPath(path));
    CHIRON_TRY(json);
    const auto presetSchema = schema(QStringLiteral("preset"));
    CHIRON_TRY(presetSchema);
    Problems problems;
    QJsonObject preset = json->root();
    const QJsonValue parameters = preset["parameters"];
    const QString at = QStringLiteral("$.parameters");
    if (parameters.isObject())
        validated(m_named.filledIn(parameters.toObject(), parameterSchema, at, problems), parameterSchema, at,
                  problems);
    if (parameters.toObject().contains(key))
        problems.push_back(
            {memberPath(at, key), QStringLiteral("given"), QStringLiteral("none: a preset names no other")});
    if (parameters.isObject())
        preset["parameters"] = QJsonObject{}; // the preset's own schema knows only that it is an object
    preset = validated(preset, **presetSchema, QStringLiteral("$"), problems).toObject();
    if (problems.empty())
        checkName(preset, QFileInfo(path).completeBaseName(), problems);
    if (problems.empty() && texts)
        texts->laid(preset, **presetSchema, {QStringLiteral("presets"), preset["id"].toString()},
                    json->name(), QStringLiteral("$"), problems);
    if (!problems.empty())
        return tl::unexpected(json->error(problems));
    return parameters.toObject();
}

core::Result<ExerciseLevel> ContentReader::level(const QString& path, const QJsonObject& exercise,
                                                 ContentTexts& texts) {
    const auto json = JsonFile::read(path);
    CHIRON_TRY(json);
    const ExerciseContent* content = findExerciseContent(exercise["id"].toString().toStdString());
    const auto levelSchema = schema(QStringLiteral("level"));
    const auto parameterSchema = schema(QString::fromUtf8(content->parametersSchema.data()));
    for (const auto* read : {&levelSchema, &parameterSchema})
        CHIRON_TRY(*read);
    Problems problems;
    QJsonObject resolved = json->root();
    QJsonValue given = resolved["parameters"];
    if (!content->presetKey.empty() && given.isObject()) {
        const auto merged = withPreset(QFileInfo(path).dir().filePath(QStringLiteral("../presets")), *content,
                                       **parameterSchema, given.toObject(), problems);
        CHIRON_TRY(merged);
        given = *merged;
    }
    if (given.isObject())
        given =
            m_named.filledIn(given.toObject(), **parameterSchema, QStringLiteral("$.parameters"), problems);
    const QJsonValue parameters =
        validated(given, **parameterSchema, QStringLiteral("$.parameters"), problems);
    resolved["parameters"] = QJsonObject{}; // the level's own schema knows only that it is an object
    resolved = validated(resolved, **levelSchema, QStringLiteral("$"), problems).toObject();
    if (!problems.empty())
        return tl::unexpected(json->error(problems));
    checkName(resolved, QFileInfo(path).completeBaseName(), problems);
    resolved =
        texts.laid(resolved, **levelSchema, {QStringLiteral("levels"), QFileInfo(path).completeBaseName()},
                   json->name(), QStringLiteral("$"), problems);
    resolved["parameters"] = parameters;
    ExerciseLevel level = levelFromResolved(resolvedDocument(exercise, resolved), problems);
    checkLevel(level, resolved, problems);
    content->check(level.parameters, QStringLiteral("$.parameters"), problems);
    if (!problems.empty())
        return tl::unexpected(json->error(problems));
    return level;
}

core::Result<Exercise> ContentReader::exercise(const QString& folder) {
    const auto json = JsonFile::read(folder + "/exercise.json");
    CHIRON_TRY(json);
    const auto exerciseSchema = schema(QStringLiteral("exercise"));
    CHIRON_TRY(exerciseSchema);
    Problems problems;
    QJsonObject resolved =
        validated(json->root(), **exerciseSchema, QStringLiteral("$"), problems).toObject();
    const QString id = resolved["id"].toString();
    checkName(resolved, QFileInfo(folder).fileName(), problems);
    const ExerciseContent* content = findExerciseContent(id.toStdString());
    if (content == nullptr)
        problems.push_back(
            {QStringLiteral("$.id"), quoted(id), QStringLiteral("an exercise this program knows")});
    if (!problems.empty())
        return tl::unexpected(json->error(problems));
    auto texts = ContentTexts::read(folder, m_languages);
    CHIRON_TRY(texts);
    resolved = texts->laid(resolved, **exerciseSchema, {QStringLiteral("exercise")}, json->name(),
                           QStringLiteral("$"), problems);
    Exercise out;
    const ObjectReader reader(resolved, QStringLiteral("$"), problems);
    out.id = reader.text("id");
    out.version = reader.integer("version");
    out.title = reader.translated("title");
    out.objective = reader.translated("objective");
    if (reader.has("advice"))
        reader.eachObject("advice", [&](const ObjectReader& entry) {
            const std::string metric = entry.text("metric");
            if (!scoring::findMetric(metric))
                problems.push_back({QStringLiteral("$.advice"), quoted(QString::fromStdString(metric)),
                                    QStringLiteral("a metric of the catalogue")});
            else if (std::any_of(out.advice.begin(), out.advice.end(),
                                 [&](const Advice& other) { return other.metric == metric; }))
                problems.push_back({QStringLiteral("$.advice"), quoted(QString::fromStdString(metric)),
                                    QStringLiteral("each metric once")});
            else
                out.advice.push_back({metric, entry.translated("text"), momentOf(entry)});
        });
    if (reader.has("legend"))
        reader.eachObject("legend", [&](const ObjectReader& entry) {
            out.legend.push_back({entry.text("mark"), entry.translated("text")});
        });
    if (!problems.empty())
        return tl::unexpected(json->error(problems));
    QJsonObject stored = resolved; // as stored with a session, without advice and legend: they are not part
                                   // of what was done
    stored.remove(QStringLiteral("advice"));
    stored.remove(QStringLiteral("legend"));
    CHIRON_TRY(checkPresets(folder + "/presets", *content, *texts));
    CHIRON_TRY(readLevels(folder, stored, *texts, out));
    CHIRON_TRY(texts->finish());
    out.textsSha256 = texts->digests();
    m_missing.insert(m_missing.end(), texts->missing().begin(), texts->missing().end());
    return out;
}

core::Result<void> ContentReader::readLevels(const QString& folder, const QJsonObject& exercise,
                                             ContentTexts& texts, Exercise& out) {
    for (const QFileInfo& file :
         QDir(folder + "/levels").entryInfoList({"*.json"}, QDir::Files, QDir::Name)) {
        auto read = level(file.filePath(), exercise, texts);
        CHIRON_TRY(read);
        out.levels.push_back(std::move(*read));
    }
    std::stable_sort(out.levels.begin(), out.levels.end(),
                     [](const ExerciseLevel& a, const ExerciseLevel& b) { return a.number < b.number; });
    return checkNumbers(out.levels, folder);
}

core::Result<std::vector<Exercise>> ContentReader::exercises() {
    auto named = NamedContent::read(m_directory, m_languages);
    CHIRON_TRY(named);
    m_named = std::move(*named);
    m_missing = m_named.missing();
    std::vector<Exercise> out;
    const QDir folder(m_directory + "/exercises");
    for (const QFileInfo& entry : folder.entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name)) {
        auto read = exercise(entry.filePath());
        CHIRON_TRY(read);
        out.push_back(std::move(*read));
    }
    const auto place = [](const Exercise& exercise) {
        return findExerciseContent(exercise.id) - exerciseContents().data();
    };
    std::stable_sort(out.begin(), out.end(),
                     [&](const Exercise& a, const Exercise& b) { return place(a) < place(b); });
    if (out.empty())
        return core::fail(
            core::ErrorCode::badInput,
            (folder.path() + ": no exercise: expected a folder for each exercise").toStdString());
    return out;
}

} // namespace chiron::catalogue
