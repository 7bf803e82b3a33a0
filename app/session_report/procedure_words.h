// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/procedure_kind.h"

#include <QString>
#include <string_view>

namespace chiron::session_report {

// The words of procedures in the program's language, from their rows; for screens and paper alike. Thread of the translator (GUI).

/// A marked text of a row or a kind.
QString procedureText(std::string_view marked);
/// By kind ("staircase") or a run's id with version ("staircase@1"); of one that is not known, its id with spaces.
QString procedureTitle(std::string_view id);
QString procedureMeaning(std::string_view id); ///< when a researcher would choose it; empty for one that is not known
/// What a word of a parameter's is called ("quantile"); the word itself where it has no title.
QString wordTitle(const psychophysics::Parameter& row, std::string_view word);

} // namespace chiron::session_report
