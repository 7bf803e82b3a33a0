// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/study/questionnaire_sheet.h"

namespace chiron::cli {

/// Sets an answer from the text of a cell: a number, a choice (by its words in any language or by its index
/// from 0), or free text. An empty cell means not answered.
void takeWords(SheetAnswer& answer, const QString& words, SheetFaults& faults);
/// Does the same for a JSON number; choices count from 0.
void takeNumber(SheetAnswer& answer, double value, SheetFaults& faults);
/// Records that the value found is not a valid answer to this question.
void refuse(SheetAnswer& answer, const QString& found, SheetFaults& faults);

} // namespace chiron::cli
