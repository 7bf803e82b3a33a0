// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/content_texts.h"
#include "catalogue/exercise.h"
#include "catalogue/exercise_contents.h"
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
    /// `languages` lists the languages that the content may be in, English first.
    ContentReader(QString directory, std::vector<std::string> languages)
        : m_directory(std::move(directory)), m_languages(std::move(languages)) {}
    ContentReader(const ContentReader&) = delete;
    ContentReader& operator=(const ContentReader&) = delete;

    core::Result<std::vector<Exercise>> exercises();
    const NamedContent& named() const { return m_named; }                 ///< valid after exercises()
    const std::vector<MissingText>& missing() const { return m_missing; } ///< valid after exercises()

private:
    core::Result<Exercise> exercise(const QString& folder);
    core::Result<ExerciseLevel> level(const QString& path, const QJsonObject& exercise, ContentTexts& texts);
    core::Result<void> readLevels(const QString& folder, const QJsonObject& exercise, ContentTexts& texts,
                                  Exercise& out);
    core::Result<const Schema*> schema(const QString& name);
    core::Result<void> checkPresets(const QString& folder, const ExerciseContent& content,
                                    ContentTexts& texts);
    /// Returns `given` laid over the parameters of the preset that it names, or of the schema's default
    /// preset.
    core::Result<QJsonObject> withPreset(const QString& folder, const ExerciseContent& content,
                                         const Schema& parameterSchema, const QJsonObject& given,
                                         Problems& problems);
    /// Returns the parameters of a preset's file, checked against the parameters' schema. Faults are reported
    /// with their place in that file. If `texts` is given, the preset's translations are checked too.
    core::Result<QJsonObject> presetParameters(const QString& path, const QString& key,
                                               const Schema& parameterSchema, ContentTexts* texts = nullptr);

    QString m_directory;
    std::vector<std::string> m_languages;
    std::vector<MissingText> m_missing;
    NamedContent m_named;
    std::map<QString, Schema> m_schemas;
};

} // namespace chiron::catalogue
