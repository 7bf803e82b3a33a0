// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/session_report/finger_words.h"

#include "modules/exercises/palpation/simulation/palpation_parameters.h"

#include <algorithm>

namespace chiron::session_report {

namespace {

struct PalpationWords {
    Q_DECLARE_TR_FUNCTIONS(PalpationWords)
};

} // namespace

EndWords palpationEnds() {
    return {MarkTexts::tr("Ended"), MarkTexts::tr("The search was reported as done"),
            MarkTexts::tr("Time was up before the search was reported as done"),
            MarkTexts::tr("The search could no longer be completed"),
            MarkTexts::tr("The tissue was damaged")};
}

QString fingerName(int tool, int hands, int fingers) {
    // A hand's second finger is to the right of its first (PalpationKind::toolPlace); on a left hand, palm
    // down, this is the index finger.
    const bool left = hands > 1 && tool / std::max(fingers, 1) > 0;
    const bool middle = fingers > 1 && (tool % fingers == 1) != left;
    if (hands < 2)
        return fingers < 2 ? PalpationWords::tr("Finger")
               : middle    ? PalpationWords::tr("Middle finger")
                           : PalpationWords::tr("Index finger");
    if (!left)
        return middle ? PalpationWords::tr("Right middle finger") : PalpationWords::tr("Right index finger");
    return middle ? PalpationWords::tr("Left middle finger") : PalpationWords::tr("Left index finger");
}

QString fingerNameOf(const catalogue::ExerciseLevel& level, int tool, int) {
    const auto& p = level.parameters.as<simulation::PalpationParameters>();
    return fingerName(tool, p.hands, p.fingers);
}

} // namespace chiron::session_report
