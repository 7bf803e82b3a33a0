// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session_report/exercise_words.h"

namespace chiron::session_report {

EndWords palpationEnds();
/// The name of the finger that tool `tool` is: "Right index finger"; "Finger" if there is only one.
QString fingerName(int tool, int hands, int fingers);
QString fingerNameOf(const catalogue::ExerciseLevel& level, int tool, int tools);

} // namespace chiron::session_report
