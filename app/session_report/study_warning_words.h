// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/run_estimate.h"
#include "psychophysics/study/warning.h"

#include <QString>

namespace chiron::session_report {

/// What to know before using a number, in words for clinicians and in the language of the program: on screens and in the printed report.
QString warningWords(const psychophysics::Warning& warning);

/// How a value was got, in the same words; empty for none.
QString methodWords(psychophysics::EstimateMethod method);

} // namespace chiron::session_report
