// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QJsonObject>
#include <QString>
#include <QStringList>
#include <utility>
#include <vector>

namespace chiron::session {

/// A column as described in the data dictionary.
struct ExportColumn {
    QString name;
    QString unit; ///< SI ("N", "s", "m/s"); "1" for fractions and counts; empty for words
    QString description;
    std::vector<std::pair<QString, QString>> levels{}; ///< value -> its meaning; empty for numbers
};

/// A table of an export. Cells are text, "n/a" if there is no value. Every row has columns.size() cells.
struct ExportTable {
    QString name; ///< "trials"
    QString description;
    std::vector<ExportColumn> columns;
    std::vector<QStringList> rows;
};

inline const QString kNotAvailable = QStringLiteral("n/a");

/// How to read a table with "n/a": one line for R and one for pandas. `table`: "trials".
QString readingWords(const QString& table);
QJsonObject readingJson(); ///< the same for programs: {"R": …, "pandas": …}

/// The shortest decimal that reads back as the same double, "n/a" for what is not finite.
QString exportNumber(double value);
QString exportFlag(bool value); ///< "1" or "0"

QByteArray csvOf(const ExportTable& table); ///< RFC 4180, lines end in \n
QByteArray tsvOf(const ExportTable& table); ///< as BIDS requires: no quotes; tabs and line ends in cells
                                            ///< become spaces
/// Columns as a BIDS sidecar describes them: {name: {Description, Units, Levels}}.
QJsonObject sidecarOf(const ExportTable& table);
/// data_dictionary.csv: how to read the tables (rows of the table "*"), followed by table, column, unit,
/// levels ("1=yes; 0=no"), description.
ExportTable dictionaryOf(const std::vector<ExportTable>& tables);

} // namespace chiron::session
