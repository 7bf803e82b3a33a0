// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"
#include "core/result.h"

#include <QByteArray>
#include <QString>
#include <vector>

namespace chiron::cli {

/// Rows of finite numbers in the order of the law's input columns. Row i stood in line i + 2.
struct LawTable {
    std::vector<std::vector<double>> rows;
};

/// Every law that can be evaluated, module by module.
const std::vector<const core::LawDescription*>& allLaws();
const core::LawDescription* findLaw(const QString& id); ///< null if there is none
QString lawNames();

/// The values of the law's parameters in its order: defaults, overridden by the JSON object in `path` (empty:
/// none). Failure: notFound; badInput with file, JSON path, value and range.
core::Result<std::vector<double>> readLawParameters(const core::LawDescription& law, const QString& path);

/// Reads a CSV with a header of the law's input columns, in any order. Every line ends in a line feed, or the table was cut off. Failure:
/// badInput with name, line and column.
core::Result<LawTable> readLawTable(const core::LawDescription& law, const QByteArray& csv,
                                    const QString& name);

/// The law's answers, row by row. Failure: badInput with name and line of the first row for which the law does not hold or gives no finite
/// number.
core::Result<std::vector<std::vector<double>>> evaluateLaw(const core::LawDescription& law, const std::vector<double>& parameters,
                                                           const LawTable& table, const QString& name);

} // namespace chiron::cli
