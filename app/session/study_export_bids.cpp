// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/bids_motion.h"
#include "session/study/questionnaire_replies.h"
#include "session/study_export.h"
#include "session/study_export_tables.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace chiron::session {

namespace {

using database::StudyTrial;

QString taskWords(psychophysics::Task task) {
    const std::string_view word = psychophysics::token(task);
    return QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size()));
}

/// The names of participants and conditions in file names, which may contain only letters and digits.
struct Labels {
    std::map<QString, QString> subject; ///< by code
    std::map<QString, QString> task;    ///< by the condition's label

    QString participantId(const QString& code) const { return QStringLiteral("sub-") + subject.at(code); }
};

Labels labelsOf(const StudyExportData& data) {
    QStringList codes, conditions;
    for (const ExportedParticipant& each : data.participants) {
        codes << QString::fromStdString(each.participant.code);
        for (const ExportedRun& run : each.runs)
            conditions << run.label;
    }
    return {bidsLabels(codes), bidsLabels(conditions)};
}

const ExportColumn kParticipantId{"participant_id", "",
                                  "sub- and the letters and digits of the participant's random code (x2, x3, "
                                  "… behind them where codes differ in other signs alone)"};

/// A table without its first columns, which identify the participant: BIDS does this by file names and by
/// participant_id.
ExportTable asParticipants(const ExportTable& table, const Labels& labels) {
    ExportTable result{table.name,
                       table.description,
                       {kParticipantId, {"code", "", "the participant's random code, as it was given"}},
                       {}};
    result.columns.insert(result.columns.end(), table.columns.begin() + 2, table.columns.end());
    for (const QStringList& row : table.rows)
        result.rows.push_back(QStringList{labels.participantId(row[1]), row[1]} + row.mid(2));
    return result;
}

core::Result<void> writeTable(NewFolder& folder, const QString& stem, const ExportTable& table,
                              const QJsonObject& head) {
    QJsonObject json = sidecarOf(table);
    for (auto it = head.begin(); it != head.end(); ++it)
        json.insert(it.key(), it.value());
    CHIRON_TRY(folder.write(stem + ".tsv", tsvOf(table)));
    return folder.write(stem + ".json", QJsonDocument(json).toJson());
}

core::Result<void> writeRun(NewFolder& folder, const StudyExportData& data,
                            const ExportedParticipant& participant, const ExportedRun& run,
                            const BidsRecording& recording) {
    ExportTable table{"beh", "every presentation of the run", trialColumns(), {}};
    for (const StudyTrial& trial : run.trials)
        table.rows.push_back(trialCells(data, run, trial));
    const auto& e = run.estimate;
    const bool sameWay = !data.blinded || data.oneTask;
    const auto number = [](double value) {
        return std::isfinite(value) ? QJsonValue(value) : QJsonValue("n/a");
    };
    const auto ofTask = [&](double value) { return sameWay ? number(value) : QJsonValue("n/a"); };
    const QJsonObject estimate{{"weber", number(e.weber)},
                               {"weber_low", number(e.weber95.low)},
                               {"weber_high", number(e.weber95.high)},
                               {"sigma_log10", number(e.sigma_log10)},
                               {"tie", ofTask(e.tie)},
                               {"tie_low", ofTask(e.tie95.low)},
                               {"tie_high", ofTask(e.tie95.high)},
                               {"exponent", ofTask(e.exponent)},
                               {"exponent_low", ofTask(e.exponent95.low)},
                               {"exponent_high", ofTask(e.exponent95.high)},
                               {"criterion", ofTask(e.criterion)},
                               {"method", sameWay ? QString::fromUtf8(methodText(e.method)) : kNotAvailable}};
    QJsonObject head{{"TaskName", recording.task},
                     {"TaskDescription", recording.taskDescription},
                     {"ProtocolSHA256", data.sha256()},
                     {"Participant", QString::fromStdString(participant.participant.code)},
                     {"Condition", run.label},
                     {"Instructions", english(data.design->instructions)},
                     {"Estimate", estimate}};
    if (!data.blinded) {
        if (!run.condition->instructions.empty())
            head.insert("ConditionInstructions", english(run.condition->instructions));
        const auto& stimulus = run.condition->stimulus;
        const std::string_view attribute = psychophysics::token(stimulus.attribute),
                               unit = psychophysics::unitOf(stimulus.attribute);
        head.insert("Attribute",
                    QString::fromUtf8(attribute.data(), static_cast<qsizetype>(attribute.size())));
        head.insert("Reference", stimulus.reference);
        head.insert("ReferenceUnits", QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size())));
    }
    return writeTable(
        folder,
        QStringLiteral("sub-%1/beh/%2%3_beh").arg(recording.subject, recording.stem(), recording.tail()),
        table, head);
}

/// The data of a participant while conditions are sealed: one line in place of the runs.
core::Result<void> writeSealed(NewFolder& folder, const StudyExportData& data,
                               const ExportedParticipant& participant, const ExportTable& quality,
                               const QString& subject) {
    // The file name identifies the participant.
    ExportTable table{
        QStringLiteral("beh"), quality.description, {quality.columns.begin() + 2, quality.columns.end()}, {}};
    for (const QStringList& row : quality.rows)
        if (row[1].toStdString() == participant.participant.code)
            table.rows.push_back(row.mid(2));
    const QJsonObject head{{"TaskName", "sealed"},
                           {"TaskDescription", "every condition; which is which, and what tells them apart, "
                                               "is left out until the study is unblinded"},
                           {"ProtocolSHA256", data.sha256()},
                           {"Participant", QString::fromStdString(participant.participant.code)}};
    return writeTable(folder, QStringLiteral("sub-%1/beh/sub-%1_task-sealed_beh").arg(subject), table, head);
}

/// Writes the recordings of a run, one per session. Omits recordings that are erased or that the actor may
/// not read.
core::Result<void> writeSittings(NewFolder& folder, database::Connection& connection,
                                 const database::Actor& actor, const ExportedRun& run,
                                 BidsRecording recording) {
    std::vector<database::SessionId> sessions;
    for (const StudyTrial& trial : run.trials)
        if (trial.session > 0 && std::find(sessions.begin(), sessions.end(), trial.session) == sessions.end())
            sessions.push_back(trial.session);
    for (std::size_t i = 0; i < sessions.size(); ++i) {
        auto session = SessionView::open(connection, actor, sessions[i]);
        if (!session) {
            if (session.error().code == core::ErrorCode::notFound ||
                session.error().code == core::ErrorCode::notAllowed)
                continue;
            return tl::unexpected(session.error());
        }
        std::vector<BidsEvent> events;
        for (const StudyTrial& trial : run.trials)
            if (trial.session == sessions[i])
                events.push_back({trial.firstTick, trial.lastTick,
                                  trial.practice          ? "practice"
                                  : trial.spoiled.empty() ? "trial"
                                                          : "spoiled",
                                  QString::number(trial.ordinal)});
        recording.acquisition = QStringLiteral("sitting%1").arg(i + 1);
        CHIRON_TRY(writeBidsMotion(folder, **session, recording, events));
    }
    return {};
}

core::Result<void> writeParticipants(NewFolder& folder, const StudyExportData& data, const Labels& labels) {
    ExportTable table = asParticipants(participantsTable(data), labels);
    // BIDS requires a folder for each line, and participants without data have none.
    std::set<QString> withData;
    for (const ExportedParticipant& each : data.participants)
        if (std::any_of(each.runs.begin(), each.runs.end(),
                        [&](const ExportedRun& run) { return data.sealed || !run.trials.empty(); }))
            withData.insert(labels.participantId(QString::fromStdString(each.participant.code)));
    std::erase_if(table.rows, [&](const QStringList& row) { return withData.count(row[0]) == 0; });
    return writeTable(folder, "participants", table, {});
}

/// The condition of a questionnaire's column, as an ending of its name and in words; empty if the
/// questionnaire is asked once.
QString endingOf(const AnsweredPart& part) {
    return part.label.empty() ? QString() : u'_' + QString::fromStdString(part.label);
}
QString aboutOf(const AnsweredPart& part) {
    return part.label.empty() ? QString()
                              : QStringLiteral("; about the condition ") + QString::fromStdString(part.label);
}

/// The scores of a part of a questionnaire by the participant's code; their columns are appended to those of
/// the questions.
std::map<QString, QStringList> scoresBy(const StudyExportData& data,
                                        const psychophysics::Questionnaire& questionnaire,
                                        const AnsweredPart& part, std::vector<ExportColumn>& columns) {
    std::map<QString, QStringList> by;
    const ExportTable scores = scoresTable(data);
    const auto cell = [&](const QStringList& row, const char* name) {
        const auto at =
            std::find_if(scores.columns.begin(), scores.columns.end(),
                         [&](const ExportColumn& column) { return column.name == QLatin1String(name); });
        return row[at - scores.columns.begin()];
    };
    QStringList names;
    for (const QStringList& row : scores.rows) {
        if (cell(row, "questionnaire").toStdString() != questionnaire.id ||
            cell(row, "condition") !=
                (part.label.empty() ? kNotAvailable : QString::fromStdString(part.label)))
            continue;
        if (const QString name = cell(row, "score"); !names.contains(name)) {
            names << name;
            columns.push_back(
                {QStringLiteral("score_") + name + endingOf(part), "",
                 QStringLiteral("score by the rule %1").arg(cell(row, "rule")) + aboutOf(part)});
        }
        by[cell(row, "participant")] << cell(row, "value");
    }
    return by;
}

/// One part of a questionnaire with the data for its columns.
struct PhenotypePart {
    AnsweredPart answered;
    std::map<QString, QStringList> scores; ///< by code
    int scoreColumns = 0;
};

/// A participant's cells of one part; empty if they answered none of its questions.
QStringList cellsOf(const psychophysics::Questionnaire& questionnaire, const PhenotypePart& part,
                    const ExportedParticipant& participant) {
    std::map<std::string, QString> given;
    QStringList languages;
    for (const database::QuestionnaireAnswer& answer : part.answered.answers) {
        if (answer.participant != participant.participant.id || !answer.number)
            continue;
        given[answer.item] = exportNumber(*answer.number);
        if (const QString language = QString::fromStdString(answer.language);
            !language.isEmpty() && !languages.contains(language))
            languages << language;
    }
    if (given.empty())
        return {};
    QStringList cells;
    for (const auto& item : questionnaire.items)
        if (item.kind != psychophysics::QuestionnaireItem::Kind::text)
            cells << (given.count(item.id) > 0 ? given.at(item.id) : kNotAvailable);
    cells << (languages.isEmpty() ? kNotAvailable : languages.join(u'|'));
    if (part.scoreColumns > 0)
        cells << part.scores.at(QString::fromStdString(participant.participant.code));
    return cells;
}

/// Writes phenotype/ID.tsv: one line per participant, one column per question; for a questionnaire asked
/// after each condition, one column per question and condition.
core::Result<void> writeQuestionnaires(NewFolder& folder, const StudyExportData& data, const Labels& labels) {
    for (const psychophysics::Questionnaire& questionnaire : data.design->questionnaires) {
        ExportTable table{
            QString::fromStdString(questionnaire.id), english(questionnaire.title), {kParticipantId}, {}};
        std::vector<PhenotypePart> parts;
        std::vector<qsizetype> widths; // number of columns of each part
        for (AnsweredPart& answered : answeredParts(*data.design, questionnaire, data.answers)) {
            const std::size_t before = table.columns.size();
            for (const auto& item : questionnaire.items)
                if (item.kind != psychophysics::QuestionnaireItem::Kind::text)
                    table.columns.push_back({QString::fromStdString(item.id) + endingOf(answered), "",
                                             english(item.text) + aboutOf(answered)});
            table.columns.push_back({QStringLiteral("language_shown") + endingOf(answered), "",
                                     QStringLiteral("in which the questions were shown, several separated by "
                                                    "|; n/a where it was not recorded") +
                                         aboutOf(answered)});
            const std::size_t questions = table.columns.size();
            PhenotypePart part{std::move(answered), {}, 0};
            part.scores = scoresBy(data, questionnaire, part.answered, table.columns);
            part.scoreColumns = static_cast<int>(table.columns.size() - questions);
            widths.push_back(static_cast<qsizetype>(table.columns.size() - before));
            parts.push_back(std::move(part));
        }
        for (const ExportedParticipant& each : data.participants) {
            QStringList row{labels.participantId(QString::fromStdString(each.participant.code))};
            bool any = false;
            for (std::size_t i = 0; i < parts.size(); ++i) {
                const QStringList cells = cellsOf(questionnaire, parts[i], each);
                any = any || !cells.isEmpty();
                for (qsizetype column = 0; column < widths[i]; ++column)
                    row << (cells.isEmpty() ? kNotAvailable : cells[column]);
            }
            if (any && !each.runs.empty())
                table.rows.push_back(row);
        }
        if (table.rows.empty())
            continue;
        if (auto written =
                writeTable(folder, QStringLiteral("phenotype/") + table.name, table,
                           {{"MeasurementToolMetadata", QJsonObject{{"Description", table.description}}}});
            !written)
            return written;
    }
    return {};
}

core::Result<void> writeHead(NewFolder& folder, const StudyExportData& data, const Labels& labels) {
    const QString blinded =
        data.blinded
            ? QStringLiteral("The study is blinded: conditions go by sealed codes; what would tell "
                             "them apart (trials, answers, times, counts, values, orders, "
                             "procedures, forces and motion, the protocol itself) is left out.\n")
            : QStringLiteral("sourcedata/design.json is the frozen protocol. Where motion was recorded, its "
                             "events are the presentations; they do not say where a lifted object was "
                             "pressed so hard that it came off the tool.\n");
    const QJsonObject description{{"Name", english(data.design->title)},
                                  {"BIDSVersion", "1.9.0"},
                                  {"DatasetType", "raw"},
                                  {"ProtocolSHA256", data.sha256()},
                                  {"Authors", QJsonArray{"n/a"}},
                                  {"GeneratedBy", QJsonArray{QJsonObject{{"Name", "Chiron"}}}}};
    // The orders and tables in it would reveal which code is which condition.
    if (!data.blinded)
        CHIRON_TRY(folder.write(QStringLiteral("sourcedata/design.json"),
                                QByteArray::fromStdString(data.record.designJson)));
    for (const auto& [name, bytes] :
         {std::pair{QStringLiteral("dataset_description.json"), QJsonDocument(description).toJson()},
          {QStringLiteral("README"),
           QStringLiteral("%1\n\n%2\n\nFrozen protocol: SHA-256 %3.\nParticipants go by random codes; names, "
                          "free text and clock times are not part of it.\n%4\n"
                          "n/a stands where there is no value.\nIn R: read.delim(\"FILE.tsv\", na.strings = "
                          "\"n/a\", quote = \"\")\n"
                          "In Python: pandas.read_csv(\"FILE.tsv\", sep=\"\\t\", na_values=[\"n/a\"], "
                          "keep_default_na=False)\n")
               .arg(english(data.design->title), english(data.design->objective), data.sha256(), blinded)
               .toUtf8()}})
        CHIRON_TRY(folder.write(name, bytes));
    CHIRON_TRY(writeParticipants(folder, data, labels));
    return writeQuestionnaires(folder, data, labels);
}

} // namespace

core::Result<void> exportStudyBids(database::StudyReader& reader, database::Connection& connection,
                                   const database::Actor& actor, database::StudyNumber study,
                                   const std::filesystem::path& folder) {
    auto made = NewFolder::begin(folder);
    CHIRON_TRY(made);
    const auto data = gatherStudy(reader, study);
    CHIRON_TRY(data);
    const Labels labels = labelsOf(*data);
    CHIRON_TRY(writeHead(*made, *data, labels));
    const ExportTable quality = qualityTable(*data);
    for (const ExportedParticipant& each : data->participants) {
        if (data->sealed && !each.runs.empty())
            CHIRON_TRY(writeSealed(*made, *data, each, quality,
                                   labels.subject.at(QString::fromStdString(each.participant.code))));
        for (const ExportedRun& run : each.runs) {
            if (run.trials.empty())
                continue;
            BidsRecording recording{labels.subject.at(QString::fromStdString(each.participant.code)),
                                    labels.task.at(run.label),
                                    {},
                                    run.index,
                                    {},
                                    data->sha256()};
            recording.taskDescription =
                data->blinded ? (data->oneTask ? taskWords(run.condition->task) : QStringLiteral("sealed"))
                              : english(run.condition->title);
            CHIRON_TRY(writeRun(*made, *data, each, run, recording));
            if (data->blinded)
                continue;
            CHIRON_TRY(writeSittings(*made, connection, actor, run, recording));
        }
    }
    return made->commit();
}

} // namespace chiron::session
