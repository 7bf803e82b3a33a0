// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/study/questionnaire_sheet.h"

#include "catalogue/json_file.h"
#include "cli/cli_errors.h"
#include "cli/csv_table.h"
#include "cli/study/questionnaire_cell.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QStringDecoder>
#include <algorithm>

namespace chiron::cli {

namespace {

using Questions = std::vector<AskedQuestion>;

/// The question of this name, or null.
const AskedQuestion* questionOf(const Questions& asked, const QString& name) {
    const auto found = std::find_if(asked.begin(), asked.end(),
                                    [&](const AskedQuestion& each) { return each.name() == name; });
    return found == asked.end() ? nullptr : &*found;
}

/// The questions of the questionnaire with which the name begins, or all questions if there are none.
QString knownQuestions(const Questions& asked, const QString& name) {
    QStringList all, alike;
    const auto questionnaire = [](const QString& of) { return of.section(u'.', 0, 0).section(u'@', 0, 0); };
    for (const AskedQuestion& each : asked) {
        all << each.name();
        if (questionnaire(all.last()) == questionnaire(name))
            alike << all.last();
    }
    return all.isEmpty()
               ? QStringLiteral("none, since the study has no questionnaires")
               : QStringLiteral("one of ") + (alike.isEmpty() ? all : alike).join(QStringLiteral(", "));
}

/// Spreadsheets often save in a regional encoding, which would corrupt names and umlauts.
core::Result<QString> utf8Text(const QByteArray& bytes, const QString& name) {
    if (bytes.startsWith("\xff\xfe") || bytes.startsWith("\xfe\xff"))
        return badInput(QStringLiteral("%1:1: UTF-16: expected UTF-8 (save it as \"CSV UTF-8\")").arg(name));
    int line = 0;
    for (const QByteArray& each : bytes.split('\n')) {
        ++line;
        QStringDecoder decoder(QStringDecoder::Utf8);
        const QString words = decoder(each);
        if (decoder.hasError() || words.contains(QChar(0)))
            return badInput(
                QStringLiteral("%1:%2: a byte that is not UTF-8: expected UTF-8 (save it as \"CSV UTF-8\")")
                    .arg(name)
                    .arg(line));
    }
    return QString::fromUtf8(bytes);
}

/// If a questionnaire (of a condition) has any column, every question of it that must be answered needs a
/// column.
void findMissingColumns(const CsvTable& table, const Questions& asked, SheetFaults& faults) {
    QStringList begun, groups;
    for (const AskedQuestion& each : asked) {
        if (!groups.contains(each.group()))
            groups << each.group();
        if (table.column(each.name()) >= 0)
            begun << each.group();
    }
    for (const QString& group : groups) {
        QStringList missing;
        for (const AskedQuestion& each : asked)
            if (each.group() == group && begun.contains(group) && each.item->required &&
                table.column(each.name()) < 0)
                missing << each.name();
        if (!missing.isEmpty())
            faults.add(QStringLiteral("%1:%2: heading").arg(table.name).arg(table.headerLine),
                       QStringLiteral("no column ") + missing.join(QStringLiteral(", ")),
                       QStringLiteral("one for each question that must be answered, or --incomplete"));
    }
}

std::vector<SheetRow> rowsOf(const CsvTable& table, const std::vector<const AskedQuestion*>& columns,
                             int codes, SheetFaults& faults) {
    std::vector<SheetRow> rows;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const QString place = QStringLiteral("%1:%2").arg(table.name).arg(table.lines[i]);
        SheetRow row{place, table.cell(i, codes), {}};
        if (row.code.isEmpty())
            faults.add(place + QStringLiteral(": column participant"), QStringLiteral("empty"),
                       QStringLiteral("a participant's code"));
        for (std::size_t c = 0; c < columns.size(); ++c) {
            if (!columns[c])
                continue;
            SheetAnswer answer{place +
                                   QStringLiteral(": column %1").arg(table.header[static_cast<qsizetype>(c)]),
                               *columns[c],
                               {},
                               {}};
            takeWords(answer, table.cell(i, static_cast<int>(c)), faults);
            row.answers.push_back(std::move(answer));
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

core::Result<std::vector<SheetRow>> readCsv(const QByteArray& bytes, const QString& name,
                                            const Questions& asked, bool incomplete, SheetFaults& faults) {
    const auto text = utf8Text(bytes, name);
    CHIRON_TRY(text);
    const auto table = parseCsvTable(*text, name);
    CHIRON_TRY(table);
    const QString heading = QStringLiteral("%1:%2: heading").arg(name).arg(table->headerLine);
    const int codes = table->column(QStringLiteral("participant"));
    std::vector<const AskedQuestion*> columns;
    for (const QString& column : table->header) {
        columns.push_back(questionOf(asked, column));
        if (!columns.back() && column != u"participant")
            faults.add(heading, quoted(column),
                       QStringLiteral("participant or ") + knownQuestions(asked, column));
    }
    if (codes < 0) {
        faults.add(heading, QStringLiteral("no column participant"),
                   QStringLiteral("one with the participants' codes"));
        return std::vector<SheetRow>();
    }
    if (!incomplete)
        findMissingColumns(*table, asked, faults);
    return rowsOf(*table, columns, codes, faults);
}

void takeJson(SheetRow& row, SheetAnswer answer, const QJsonValue& value, SheetFaults& faults) {
    if (value.isDouble())
        takeNumber(answer, value.toDouble(), faults);
    else if (value.isString())
        takeWords(answer, value.toString().trimmed(), faults);
    else if (!value.isNull())
        refuse(answer, QStringLiteral("neither a number nor words"), faults);
    row.answers.push_back(std::move(answer));
}

SheetRow jsonRow(const QJsonObject& json, const QString& place, const Questions& asked, SheetFaults& faults) {
    SheetRow row{place, json["participant"].toString().trimmed(), {}};
    if (row.code.isEmpty())
        faults.add(place + QStringLiteral(".participant"), QStringLiteral("missing or empty"),
                   QStringLiteral("a participant's code"));
    for (const QString& key : json.keys())
        if (key != u"participant" && key != u"answers")
            faults.add(place, quoted(key), QStringLiteral("participant and answers"));
    if (!json["answers"].isObject())
        faults.add(place + QStringLiteral(".answers"), QStringLiteral("missing or no object"),
                   QStringLiteral("questionnaires by their ids"));
    const QJsonObject answers = json["answers"].toObject();
    for (const QString& id : answers.keys()) {
        const QString at = place + QStringLiteral(".answers.") + id;
        if (!answers[id].isObject())
            faults.add(at, QStringLiteral("no object"), QStringLiteral("answers by the questions' ids"));
        const QJsonObject items = answers[id].toObject();
        for (const QString& item : items.keys()) {
            const AskedQuestion* question = questionOf(asked, id + u'.' + item);
            if (!question)
                faults.add(at, quoted(item), knownQuestions(asked, id));
            else
                takeJson(row, {at + u'.' + item, *question, {}, {}}, items[item], faults);
        }
    }
    return row;
}

core::Result<std::vector<SheetRow>> readJson(const QByteArray& bytes, const QString& name,
                                             const Questions& asked, const QString& sha256,
                                             SheetFaults& faults) {
    const auto file = catalogue::JsonFile::parse(bytes, name);
    CHIRON_TRY(file);
    const QJsonObject& root = file->root();
    for (const QString& key : root.keys())
        if (!QStringList{"study", "design_sha256", "questions", "participants"}.contains(key))
            faults.add(name + QStringLiteral(": $"), quoted(key),
                       QStringLiteral("study, design_sha256, questions and participants"));
    if (const QString given = root["design_sha256"].toString();
        root.contains("design_sha256") && given != sha256)
        faults.add(name + QStringLiteral(": $.design_sha256"), quoted(given),
                   sha256 + QStringLiteral(", this study's design"));
    if (!root["participants"].isArray())
        faults.add(name + QStringLiteral(": $.participants"), QStringLiteral("missing or no array"),
                   QStringLiteral("an array of participants"));
    std::vector<SheetRow> rows;
    const QJsonArray participants = root["participants"].toArray();
    for (qsizetype i = 0; i < participants.size(); ++i)
        rows.push_back(jsonRow(participants[i].toObject(),
                               QStringLiteral("%1: $.participants[%2]").arg(name).arg(i), asked, faults));
    return rows;
}

} // namespace

core::Result<std::vector<SheetRow>> readSheet(const QByteArray& bytes, const QString& name,
                                              const std::vector<AskedQuestion>& asked, const QString& sha256,
                                              bool incomplete, SheetFaults& faults) {
    const QByteArray start = (bytes.startsWith("\xef\xbb\xbf") ? bytes.mid(3) : bytes).trimmed();
    return start.startsWith('{') ? readJson(start, name, asked, sha256, faults)
                                 : readCsv(bytes, name, asked, incomplete, faults);
}

} // namespace chiron::cli
