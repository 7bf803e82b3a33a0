// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session_report/exercise_words.h"

namespace chiron::session_report {

EndWords comparisonEnds();

} // namespace chiron::session_report
