// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/session_report/finger_words.h"

#include <QCoreApplication>
#include <algorithm>

namespace chiron::session_report {

namespace {

struct PalpationWords {
    Q_DECLARE_TR_FUNCTIONS(PalpationWords)
};

} // namespace

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

} // namespace chiron::session_report
