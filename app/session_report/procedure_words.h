// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/procedure_kind.h"

#include <QString>
#include <string_view>

namespace chiron::session_report {

// The words of psychophysical procedures in the program's language, from the procedures' catalogue rows, for
// screens and paper. Call these functions on the translator's thread (GUI).

/// The translation of a marked text of a row or a procedure.
QString procedureText(std::string_view marked);
/// The title of a procedure, by its name ("staircase") or a run's id with version ("staircase@1"); the id
/// with spaces if it is not known.
QString procedureTitle(std::string_view id);
/// When a researcher would choose the procedure; empty if it is not known.
QString procedureMeaning(std::string_view id);
/// The title of a parameter's word ("quantile"); the word itself if it has no title.
QString wordTitle(const psychophysics::Parameter& row, std::string_view word);

} // namespace chiron::session_report
