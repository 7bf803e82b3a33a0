// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study_export.h"

#include "session/new_folder.h"
#include "session/study_export_tables.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace chiron::session {

namespace {

QByteArray dictionaryJson(const StudyExportData& data, const std::vector<ExportTable>& tables) {
    QJsonObject files;
    for (const ExportTable& table : tables) {
        QJsonArray order;
        for (const ExportColumn& column : table.columns)
            order.append(column.name);
        files.insert(table.name + ".csv", QJsonObject{{"description", table.description},
                                                      {"columns", sidecarOf(table)},
                                                      {"order", order},
                                                      {"rows", static_cast<qint64>(table.rows.size())}});
    }
    return QJsonDocument(QJsonObject{{"protocol_sha256", data.sha256()},
                                     {"missing", kNotAvailable},
                                     {"reading", readingJson()},
                                     {"files", files}})
        .toJson();
}

/// The metadata of Psych-DS (schema.org's Dataset): a description of the data set and its variables.
QByteArray descriptionJson(const StudyExportData& data, const std::vector<ExportTable>& tables) {
    QJsonArray variables;
    QStringList named;
    for (const ExportTable& table : tables)
        for (const ExportColumn& column : table.columns)
            if (!named.contains(column.name)) {
                named << column.name;
                variables.append(QJsonObject{{"@type", "PropertyValue"},
                                             {"name", column.name},
                                             {"description", column.description},
                                             {"unitText", column.unit}});
            }
    return QJsonDocument(QJsonObject{{"@context", "https://schema.org/"},
                                     {"@type", "Dataset"},
                                     {"name", english(data.design->title)},
                                     {"description", english(data.design->objective)},
                                     {"identifier", "sha256:" + data.sha256()},
                                     {"variableMeasured", variables},
                                     {"blinded", data.blinded}})
        .toJson();
}

QByteArray readme(const StudyExportData& data) {
    return QStringLiteral(
               "Data of the study %1, protocol SHA-256 %2.\n\n"
               "trials.csv, runs.csv, participants.csv, questionnaires.csv, scores.csv, estimates.csv and "
               "quality.csv; what each column means is in data_dictionary.csv and\n"
               "data_dictionary.json. UTF-8, decimal points, SI units, n/a where there is no value: readers "
               "have to be told.\n"
               "%4"
               "Participants go by random codes. Names, accounts, free text and clock times are not part of "
               "it.\n%3")
        .arg(QString::fromStdString(data.record.summary.key), data.sha256(),
             data.sealed ? QStringLiteral(
                               "The study is blinded: conditions go by sealed codes, and whatever could tell "
                               "them apart is left out: trials, answers, times, speeds, counts, estimates,\n"
                               "values, units, orders, procedures and the protocol itself. quality.csv tells "
                               "how well trials went, by participant. Rows are ordered by codes.\n"
                               "An export after unblinding holds all of it, under the same SHA-256.\n")
             : data.blinded
                 ? QStringLiteral("The study is blinded: conditions go by sealed codes. They are alike in "
                                  "all that the program does.\n")
                 : QStringLiteral(
                       "design.json is the frozen protocol, byte for byte what the SHA-256 is of.\n"),
             readingWords("trials"))
        .toUtf8();
}

} // namespace

core::Result<void> exportStudyCsv(database::StudyReader& reader, database::StudyNumber study,
                                  const std::filesystem::path& folder) {
    auto made = NewFolder::begin(folder);
    CHIRON_TRY(made);
    const auto data = gatherStudy(reader, study);
    CHIRON_TRY(data);
    const std::vector<ExportTable> tables{
        trialsTable(*data), runsTable(*data),      participantsTable(*data), questionnairesTable(*data),
        scoresTable(*data), estimatesTable(*data), qualityTable(*data)};
    std::vector<std::pair<QString, QByteArray>> files;
    for (const ExportTable& table : tables)
        files.emplace_back(table.name + ".csv", csvOf(table));
    files.emplace_back("data_dictionary.csv", csvOf(dictionaryOf(tables)));
    files.emplace_back("data_dictionary.json", dictionaryJson(*data, tables));
    // The orders and tables in it would reveal which code is which condition.
    if (!data->blinded)
        files.emplace_back("design.json", QByteArray::fromStdString(data->record.designJson));
    files.emplace_back("dataset_description.json", descriptionJson(*data, tables));
    files.emplace_back("README.txt", readme(*data));
    for (const auto& [name, bytes] : files)
        CHIRON_TRY(made->write(name, bytes));
    return made->commit();
}

} // namespace chiron::session
