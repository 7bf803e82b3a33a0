// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"
#include "core/result.h"

#include <QByteArray>
#include <QString>
#include <vector>

namespace chiron::cli {

/// Rows of finite numbers in the order of the law's input columns. Row i comes from line i + 2 of the file.
struct LawTable {
    std::vector<std::vector<double>> rows;
};

/// Every law that can be evaluated, ordered by module.
const std::vector<const core::LawDescription*>& allLaws();
const core::LawDescription* findLaw(const QString& id); ///< null if there is none
QString lawNames();

/// The values of the law's parameters in the law's order: the defaults, overridden by the JSON object in the
/// file `path` (if `path` is not empty).
/// Errors: notFound; badInput with file, JSON path, value and range.
core::Result<std::vector<double>> readLawParameters(const core::LawDescription& law, const QString& path);

/// Reads a CSV table whose header holds the law's input columns in any order. Every line must end in a line
/// feed; a missing one means that the table was cut off.
/// Errors: badInput with name, line and column.
core::Result<LawTable> readLawTable(const core::LawDescription& law, const QByteArray& csv,
                                    const QString& name);

/// The outputs of the law, one row per input row.
/// Errors: badInput with name and line of the first row for which the law does not hold or returns a number
///   that is not finite.
core::Result<std::vector<std::vector<double>>> evaluateLaw(const core::LawDescription& law,
                                                           const std::vector<double>& parameters,
                                                           const LawTable& table, const QString& name);

} // namespace chiron::cli
