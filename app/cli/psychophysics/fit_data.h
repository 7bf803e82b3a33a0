// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/arguments.h"
#include "psychophysics/fits/fit_types.h"

#include <QJsonObject>
#include <QStringList>
#include <utility>
#include <vector>

namespace chiron::cli {

/// The answers of one group: of one participant, of one condition, or of the whole table.
struct AnswersOf {
    QStringList group; ///< values of the --by columns; empty without --by
    psychophysics::PsychometricData data;
    QString leftOut; ///< lines of the unusable rows; empty if all rows are usable
};

struct AnswerTable {
    QStringList by;                ///< columns of --by
    std::vector<AnswersOf> groups; ///< in the order of first appearance; a single one without --by
};

/// Reads rows of counts (intensity,n_correct,n_total) or of single trials (intensity,correct with 1 or 0).
/// --intensity and --correct give other names for these columns; --by COLUMN[,COLUMN] splits the rows into
/// groups by the values of these columns. An impossible row (more correct answers than trials, no intensity,
/// no answer) is bad input if the table holds single trials or groups, unless --drop-bad leaves it out. In a
/// table of plain counts it is left out and listed in AnswersOf::leftOut.
core::Result<AnswerTable> readAnswers(const Arguments& arguments);

/// Reads --function, --scale, --guess and --lapse.
/// Errors: wrongUse.
core::Result<psychophysics::FitOptions> readCurve(const Arguments& arguments);

/// A group as {column: value}.
QJsonObject groupJson(const QStringList& by, const QStringList& group);

/// The options of every command that reads answers and fits curves, for the command table.
std::vector<OptionSpec> answerOptions();
std::vector<OptionSpec> curveOptions();

} // namespace chiron::cli
