// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "catalogue/exercise_kinds.h"
#include "catalogue/json_file.h"
#include "catalogue/named_content.h"
#include "catalogue/schema.h"
#include "core/result.h"

#include <QString>
#include <map>
#include <string>

namespace chiron::catalogue {

/// Reads the exercises of one content folder against its schemas.
class ContentReader {
public:
    explicit ContentReader(QString directory) : m_directory(std::move(directory)) {}
    ContentReader(const ContentReader&) = delete;
    ContentReader& operator=(const ContentReader&) = delete;

    core::Result<std::vector<Exercise>> exercises();
    const NamedContent& named() const { return m_named; } ///< after exercises()

private:
    core::Result<Exercise> exercise(const QString& folder);
    core::Result<ExerciseLevel> level(const QString& path, const QJsonObject& exercise);
    core::Result<const Schema*> schema(const QString& name);
    core::Result<void> checkPresets(const QString& folder, const ExerciseKind& kind);
    /// `given` over the parameters of the preset that it names, or the schema's default one.
    core::Result<QJsonObject> withPreset(const QString& folder, const ExerciseKind& kind, const Schema& parameterSchema,
                                         const QJsonObject& given, Problems& problems);
    /// Of a preset's file, checked against the parameters' schema; a fault is told with its place in that file.
    core::Result<QJsonObject> presetParameters(const QString& path, const QString& key, const Schema& parameterSchema);

    QString m_directory;
    NamedContent m_named;
    std::map<QString, Schema> m_schemas;
};

} // namespace chiron::catalogue
