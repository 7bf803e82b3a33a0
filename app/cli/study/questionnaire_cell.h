// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/study/questionnaire_sheet.h"

namespace chiron::cli {

/// Gives an answer what a cell says: a number, a choice by its words in any language or its index from 0, free text. Empty: not answered.
void takeWords(SheetAnswer& answer, const QString& words, SheetFaults& faults);
/// The same of a JSON number: a choice counts from 0.
void takeNumber(SheetAnswer& answer, double value, SheetFaults& faults);
/// Notes that what is there is no answer to this question.
void refuse(SheetAnswer& answer, const QString& found, SheetFaults& faults);

} // namespace chiron::cli
