// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/arguments.h"
#include "psychophysics/fits/fit_types.h"

#include <QJsonObject>
#include <QStringList>
#include <utility>
#include <vector>

namespace chiron::cli {

/// Answers of one group: of one participant, one condition, or all there are.
struct AnswersOf {
    QStringList group; ///< values of the columns of --by; empty without
    psychophysics::PsychometricData data;
    QString leftOut; ///< where the rows are that cannot be used; empty: all can
};

struct AnswerTable {
    QStringList by; ///< columns of --by
    std::vector<AnswersOf> groups; ///< in the order in which the file has them first; one without --by
};

/// Rows of counts (intensity,n_correct,n_total) or of single trials (intensity,correct with 1 or 0); --intensity, --correct: other names of these
/// columns; --by COLUMN[,COLUMN]: apart by the values there. A row that cannot be (more right than there were, no intensity, no answer) of trials or
/// of groups is bad input, unless --drop-bad leaves it out; of plain counts it is left out and named in AnswersOf::leftOut.
core::Result<AnswerTable> readAnswers(const Arguments& arguments);

/// --function, --scale, --guess and --lapse. Failure: wrongUse.
core::Result<psychophysics::FitOptions> readCurve(const Arguments& arguments);

/// {column: value} of a group.
QJsonObject groupJson(const QStringList& by, const QStringList& group);

/// Options of every command that reads answers and fits curves, for its row in the command table.
std::vector<OptionSpec> answerOptions();
std::vector<OptionSpec> curveOptions();

} // namespace chiron::cli
