// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/instrument_catalogue.h"

#include "catalogue/catalogue.h"
#include "catalogue/content_texts.h"
#include "catalogue/json_file.h"
#include "catalogue/object_reader.h"
#include "catalogue/study_parts.h"
#include "catalogue/whole_file.h"

#include <QDir>
#include <QFileInfo>

namespace chiron::catalogue {

namespace {

core::Result<Instrument> readInstrument(const QByteArray& text, const std::string& file, const QString& name,
                                        const Schema* schema, ContentTexts& texts) {
    const auto json = JsonFile::parse(text, QString::fromStdString(file));
    CHIRON_TRY(json);
    Problems problems;
    const ObjectReader all(json->root(), QStringLiteral("$"), problems);
    refuseUnknownKeys(all, {"source", "permission", "questionnaire"},
                      QStringLiteral("a key of an instrument"));
    Instrument out;
    out.source = all.text("source");
    out.permission = all.text("permission");
    const ObjectReader questionnaire = all.object("questionnaire");
    const QString id = QFileInfo(name).completeBaseName();
    const QJsonObject translated =
        schema ? texts.laid(questionnaire.json(), *schema, {id}, QString::fromStdString(file),
                            questionnaire.path(), problems)
               : questionnaire.json();
    out.questionnaire = readQuestionnaire({translated, questionnaire.path(), problems});
    if (out.questionnaire.id + ".json" != name.toStdString())
        problems.push_back({QStringLiteral("$.questionnaire.id"),
                            QString::fromStdString(out.questionnaire.id),
                            QStringLiteral("the name of its file")});
    if (problems.empty())
        return out;
    return tl::unexpected(json->error(problems));
}

} // namespace

core::Result<std::vector<Instrument>> loadInstruments(const std::string& contentDirectory,
                                                      const std::vector<std::string>& languages) {
    constexpr qint64 kLargest_bytes = 1 << 20;
    const auto directory =
        contentDirectory.empty() ? findContentDirectory() : core::Result<std::string>(contentDirectory);
    CHIRON_TRY(directory);
    const QDir folder(QString::fromStdString(*directory) + "/instruments");
    auto texts = ContentTexts::read(folder.path(), languages);
    CHIRON_TRY(texts);
    const auto schema =
        texts->schemaOfTexts(QString::fromStdString(*directory), QStringLiteral("study_questionnaire"));
    CHIRON_TRY(schema);
    std::vector<Instrument> out;
    for (const QString& name : folder.entryList({"*.json"}, QDir::Files, QDir::Name)) {
        const std::string path = folder.filePath(name).toStdString();
        const auto text = readWholeFile(folder.filePath(name), kLargest_bytes);
        CHIRON_TRY(text);
        auto read = readInstrument(*text, path, name, *schema ? &**schema : nullptr, *texts);
        CHIRON_TRY(read);
        out.push_back(std::move(*read));
    }
    CHIRON_TRY(texts->finish());
    return out;
}

} // namespace chiron::catalogue
