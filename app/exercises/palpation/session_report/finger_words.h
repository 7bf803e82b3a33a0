// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session_report/exercise_words.h"

namespace chiron::session_report {

EndWords palpationEnds();
/// Which finger tool `tool` is: "Right index finger"; of one alone "Finger".
QString fingerName(int tool, int hands, int fingers);
QString fingerNameOf(const catalogue::ExerciseLevel& level, int tool, int tools);

} // namespace chiron::session_report
