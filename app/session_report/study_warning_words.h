// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/run_estimate.h"
#include "psychophysics/study/warning.h"

#include <QString>

namespace chiron::session_report {

/// A warning to read before using a number, in words for clinicians and in the program's language, for
/// screens and the printed report.
QString warningWords(const psychophysics::Warning& warning);

/// The method by which a value was obtained, in the same style; empty if there is none.
QString methodWords(psychophysics::EstimateMethod method);

} // namespace chiron::session_report
