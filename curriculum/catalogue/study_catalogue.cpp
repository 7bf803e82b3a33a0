// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/study_catalogue.h"

#include "catalogue/catalogue.h"
#include "catalogue/study_json.h"
#include "catalogue/whole_file.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>

namespace chiron::catalogue {

namespace {

/// Reads a study's file and lays the translations over it.
core::Result<psychophysics::StudyDesign> readTemplate(const QString& path, const Schema* schema,
                                                      ContentTexts& texts) {
    constexpr qint64 kLargest_bytes = 1 << 20;
    const auto bytes = readWholeFile(path, kLargest_bytes);
    CHIRON_TRY(bytes);
    const auto json = JsonFile::parse(*bytes, path);
    CHIRON_TRY(json);
    const QString id = QFileInfo(path).completeBaseName();
    Problems problems;
    const QJsonObject document =
        schema ? texts.laid(json->root(), *schema, {id}, path, QStringLiteral("$"), problems) : json->root();
    auto study = readStudy(document, *json);
    if (study && !problems.empty())
        return tl::unexpected(json->error(problems));
    if (study && QString::fromStdString(study->id) != id)
        return core::fail(core::ErrorCode::badInput, path.toStdString() + ": $.id: \"" + study->id +
                                                         "\": expected the name of its file");
    return study;
}

} // namespace

core::Result<StudyCatalogue> StudyCatalogue::load(const std::string& contentDirectory,
                                                  const std::vector<std::string>& languages) {
    const auto directory =
        contentDirectory.empty() ? findContentDirectory() : core::Result<std::string>(contentDirectory);
    CHIRON_TRY(directory);
    const QDir folder(QString::fromStdString(*directory) + "/studies");
    auto texts = ContentTexts::read(folder.path(), languages);
    CHIRON_TRY(texts);
    const auto schema = texts->schemaOfTexts(QString::fromStdString(*directory), QStringLiteral("study"));
    CHIRON_TRY(schema);
    StudyCatalogue out;
    std::string faults;
    for (const QString& name : folder.entryList({"*.json"}, QDir::Files, QDir::Name)) {
        auto study = readTemplate(folder.filePath(name), *schema ? &**schema : nullptr, *texts);
        if (study)
            out.m_studies.push_back(*std::move(study));
        else
            faults += (faults.empty() ? "" : "\n") + study.error().message;
    }
    if (const auto finished = texts->finish(); !finished)
        faults += (faults.empty() ? "" : "\n") + finished.error().message;
    if (!faults.empty())
        return core::fail(core::ErrorCode::badInput, faults);
    out.m_missingTexts = texts->missing();
    return out;
}

const psychophysics::StudyDesign* StudyCatalogue::find(std::string_view id) const noexcept {
    const auto found =
        std::find_if(m_studies.begin(), m_studies.end(), [&](const auto& study) { return study.id == id; });
    return found == m_studies.end() ? nullptr : &*found;
}

} // namespace chiron::catalogue
