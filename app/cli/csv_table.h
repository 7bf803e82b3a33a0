// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QString>
#include <QStringList>
#include <vector>

namespace chiron::cli {

/// A CSV file from a user: a heading, followed by rows with the same number of cells. Cells are separated by
/// commas, or by tabs or semicolons if the heading has no comma. Double quotes around a cell may enclose
/// separators and line ends. The reader skips empty lines, rows of empty cells, and lines that begin with #
/// (also if # begins the first of several cells, because spreadsheets save a note in that way).
struct CsvTable {
    QString name; ///< the file, for messages
    QStringList header;
    std::vector<QStringList> rows;
    std::vector<int> lines; ///< line on which each row begins, from 1
    int headerLine = 1;

    /// -1 if there is no such column.
    int column(const QString& heading) const { return static_cast<int>(header.indexOf(heading)); }
    const QString& cell(std::size_t row, int column) const { return rows[row][column]; }
    /// `FILE:LINE: column NAME: "VALUE": expected ...`
    tl::unexpected<core::Error> fault(std::size_t row, int column, const QString& expected) const;
    /// Reads a number in C notation. Returns NaN for an empty cell, na, n/a or nan.
    /// Errors: badInput naming the place.
    core::Result<double> number(std::size_t row, int column) const;
};

/// Reads a table from a file.
/// Errors: notFound; badInput naming file and line (no heading, no rows, a heading that occurs twice, a row
///   of another length).
core::Result<CsvTable> readCsvTable(const QString& path);
/// Does the same for text that is already in memory; messages refer to it as `name`.
core::Result<CsvTable> parseCsvTable(QString text, const QString& name);

} // namespace chiron::cli
