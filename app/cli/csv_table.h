// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QString>
#include <QStringList>
#include <vector>

namespace chiron::cli {

/// A CSV file as people hand it in: a heading, then rows of as many cells; separated by commas, or by tabs or semicolons where the heading
/// has no comma; double quotes around a cell may hold separators and line ends. Left out are empty lines, rows of empty cells, and what
/// begins with # (also as the first of several cells, as spreadsheets write a note back).
struct CsvTable {
    QString name; ///< the file, for messages
    QStringList header;
    std::vector<QStringList> rows;
    std::vector<int> lines; ///< of each row, from 1: where it begins
    int headerLine = 1;

    int column(const QString& heading) const { return static_cast<int>(header.indexOf(heading)); } ///< -1: none
    const QString& cell(std::size_t row, int column) const { return rows[row][column]; }
    /// `FILE:LINE: column NAME: "VALUE": expected ...`
    tl::unexpected<core::Error> fault(std::size_t row, int column, const QString& expected) const;
    /// A number as C writes it; not a number for an empty cell, na, n/a or nan. Failure: badInput with the place.
    core::Result<double> number(std::size_t row, int column) const;
};

/// Failure: notFound, badInput (file and line; no heading, no rows, a heading twice, a row of another length).
core::Result<CsvTable> readCsvTable(const QString& path);
/// The same of text that is read already; `name` is what messages call it.
core::Result<CsvTable> parseCsvTable(QString text, const QString& name);

} // namespace chiron::cli
