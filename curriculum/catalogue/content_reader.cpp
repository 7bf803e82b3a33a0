// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/content_reader.h"

#include "catalogue/exercise_kinds.h"
#include "catalogue/level_checks.h"
#include "catalogue/resolved_level.h"

#include <QDir>
#include <QFileInfo>
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

} // namespace

core::Result<const Schema*> ContentReader::schema(const QString& name) {
    if (const auto known = m_schemas.find(name); known != m_schemas.end())
        return &known->second;
    auto read = readSchema(m_directory + "/schema", name);
    if (!read)
        return tl::unexpected(read.error());
    return &m_schemas.emplace(name, std::move(*read)).first->second;
}

core::Result<ExerciseLevel> ContentReader::level(const QString& path, const QJsonObject& exercise) {
    const auto json = JsonFile::read(path);
    if (!json)
        return tl::unexpected(json.error());
    const ExerciseKind* kind = findExerciseKind(exercise["id"].toString().toStdString());
    const auto levelSchema = schema(QStringLiteral("level"));
    const auto parameterSchema = schema(QString::fromUtf8(kind->parametersSchema.data()));
    for (const auto* read : {&levelSchema, &parameterSchema})
        if (!*read)
            return tl::unexpected(read->error());
    Problems problems;
    QJsonObject resolved = json->root();
    const QJsonValue parameters =
        validated(resolved["parameters"], **parameterSchema, QStringLiteral("$.parameters"), problems);
    resolved["parameters"] = QJsonObject{}; // the level's own schema knows only that it is an object
    resolved = validated(resolved, **levelSchema, QStringLiteral("$"), problems).toObject();
    resolved["parameters"] = parameters;
    if (!problems.empty())
        return tl::unexpected(json->error(problems));
    checkName(resolved, QFileInfo(path).completeBaseName(), problems);
    ExerciseLevel level = levelFromResolved(resolvedDocument(exercise, resolved), problems);
    checkLevel(level, resolved, problems);
    kind->check(level.parameters, QStringLiteral("$.parameters"), problems);
    if (!problems.empty())
        return tl::unexpected(json->error(problems));
    return level;
}

core::Result<Exercise> ContentReader::exercise(const QString& folder) {
    const auto json = JsonFile::read(folder + "/exercise.json");
    if (!json)
        return tl::unexpected(json.error());
    const auto exerciseSchema = schema(QStringLiteral("exercise"));
    if (!exerciseSchema)
        return tl::unexpected(exerciseSchema.error());
    Problems problems;
    const QJsonObject resolved =
        validated(json->root(), **exerciseSchema, QStringLiteral("$"), problems).toObject();
    const QString id = resolved["id"].toString();
    checkName(resolved, QFileInfo(folder).fileName(), problems);
    if (findExerciseKind(id.toStdString()) == nullptr)
        problems.push_back(
            {QStringLiteral("$.id"), quoted(id), QStringLiteral("an exercise this program knows")});
    if (!problems.empty())
        return tl::unexpected(json->error(problems));
    Exercise out;
    const ObjectReader reader(resolved, QStringLiteral("$"), problems);
    out.id = reader.text("id");
    out.version = reader.integer("version");
    out.title = reader.translated("title");
    out.objective = reader.translated("objective");
    for (const QFileInfo& file :
         QDir(folder + "/levels").entryInfoList({"*.json"}, QDir::Files, QDir::Name)) {
        auto read = level(file.filePath(), resolved);
        if (!read)
            return tl::unexpected(read.error());
        out.levels.push_back(std::move(*read));
    }
    std::stable_sort(out.levels.begin(), out.levels.end(),
                     [](const ExerciseLevel& a, const ExerciseLevel& b) { return a.number < b.number; });
    if (auto numbers = checkNumbers(out.levels, folder); !numbers)
        return tl::unexpected(numbers.error());
    return out;
}

core::Result<std::vector<Exercise>> ContentReader::exercises() {
    std::vector<Exercise> out;
    const QDir folder(m_directory + "/exercises");
    for (const QFileInfo& entry : folder.entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name)) {
        auto read = exercise(entry.filePath());
        if (!read)
            return tl::unexpected(read.error());
        out.push_back(std::move(*read));
    }
    if (out.empty())
        return core::fail(
            core::ErrorCode::badInput,
            (folder.path() + ": no exercise: expected a folder for each exercise").toStdString());
    return out;
}

} // namespace chiron::catalogue
