// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study_export_table.h"

#include <QLocale>
#include <cmath>

namespace chiron::session {

namespace {

QString quotedCell(QString cell) {
    if (!cell.contains(u',') && !cell.contains(u'"') && !cell.contains(u'\n') && !cell.contains(u'\r'))
        return cell;
    return u'"' + cell.replace(QStringLiteral("\""), QStringLiteral("\"\"")) + u'"';
}

QString plainCell(QString cell) {
    for (QChar& c : cell)
        if (c == u'\t' || c == u'\n' || c == u'\r')
            c = u' ';
    return cell.isEmpty() ? kNotAvailable : cell;
}

QByteArray joined(const ExportTable& table, QChar separator, QString (*written)(QString)) {
    QByteArray text;
    QStringList cells;
    for (const ExportColumn& column : table.columns)
        cells << written(column.name);
    text += cells.join(separator).toUtf8() + '\n';
    for (const QStringList& row : table.rows) {
        cells.clear();
        for (const QString& cell : row)
            cells << written(cell);
        text += cells.join(separator).toUtf8() + '\n';
    }
    return text;
}

} // namespace

QString readingWords(const QString& table) {
    const QJsonObject lines = readingJson();
    return QStringLiteral("In R: %1\nIn Python: %2\n")
        .arg(lines["R"].toString(), lines["pandas"].toString())
        .replace(QStringLiteral("FILE"), table + QStringLiteral(".csv"));
}

QJsonObject readingJson() {
    return {{"R", R"(read.csv("FILE", na.strings = "n/a"))"},
            {"pandas", R"(pandas.read_csv("FILE", na_values=["n/a"], keep_default_na=False))"}};
}

QString exportNumber(double value) {
    return std::isfinite(value) ? QString::number(value, 'g', QLocale::FloatingPointShortest) : kNotAvailable;
}

QString exportFlag(bool value) {
    return value ? QStringLiteral("1") : QStringLiteral("0");
}

QByteArray csvOf(const ExportTable& table) {
    return joined(table, u',', quotedCell);
}

QByteArray tsvOf(const ExportTable& table) {
    return joined(table, u'\t', plainCell);
}

QJsonObject sidecarOf(const ExportTable& table) {
    QJsonObject json;
    for (const ExportColumn& column : table.columns) {
        QJsonObject entry{{"Description", column.description}};
        if (!column.unit.isEmpty())
            entry.insert("Units", column.unit);
        QJsonObject levels;
        for (const auto& [value, meaning] : column.levels)
            levels.insert(value, meaning);
        if (!levels.isEmpty())
            entry.insert("Levels", levels);
        json.insert(column.name, entry);
    }
    return json;
}

ExportTable dictionaryOf(const std::vector<ExportTable>& tables) {
    ExportTable dictionary{QStringLiteral("data_dictionary"),
                           QStringLiteral("every column of every table"),
                           {{"table", "", "name of the file without its ending"},
                            {"column", "", "name of the column"},
                            {"unit", "", "SI unit; 1 for shares and counts"},
                            {"levels", "", "the values that words and flags take"},
                            {"description", "", "what it says"}},
                           {}};
    const QJsonObject reading = readingJson();
    for (const QString& program : reading.keys())
        dictionary.rows.push_back(
            {QStringLiteral("*"), QStringLiteral("*"), kNotAvailable, QStringLiteral("n/a=no value"),
             QStringLiteral("every file is read in %1 with: %2").arg(program, reading[program].toString())});
    for (const ExportTable& table : tables) {
        for (const ExportColumn& column : table.columns) {
            QStringList levels;
            for (const auto& [value, meaning] : column.levels)
                levels << value + u'=' + meaning;
            dictionary.rows.push_back(
                {table.name, column.name, column.unit.isEmpty() ? kNotAvailable : column.unit,
                 levels.isEmpty() ? kNotAvailable : levels.join(QStringLiteral("; ")), column.description});
        }
    }
    return dictionary;
}

} // namespace chiron::session
