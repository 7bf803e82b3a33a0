// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/tool_words.h"

#include <QCoreApplication>
#include <algorithm>

namespace chiron::session_report {

namespace {

struct GraspWords {
    Q_DECLARE_TR_FUNCTIONS(GraspWords)
};
struct PalpationWords {
    Q_DECLARE_TR_FUNCTIONS(PalpationWords)
};

} // namespace

QString instrumentName(int tool, int tools) {
    if (tools <= 1)
        return GraspWords::tr("Instrument");
    return tool == 0 ? GraspWords::tr("Right instrument") : tool == 1 ? GraspWords::tr("Left instrument") : GraspWords::tr("Instrument %1").arg(tool + 1);
}

QString fingerName(int tool, int hands, int fingers) {
    // A hand's second finger is on the right of its first (PalpationKind::toolPlace): of a left hand, palm down, that is the index.
    const bool left = hands > 1 && tool / std::max(fingers, 1) > 0;
    const bool middle = fingers > 1 && (tool % fingers == 1) != left;
    if (hands < 2)
        return fingers < 2 ? PalpationWords::tr("Finger") : middle ? PalpationWords::tr("Middle finger") : PalpationWords::tr("Index finger");
    if (!left)
        return middle ? PalpationWords::tr("Right middle finger") : PalpationWords::tr("Right index finger");
    return middle ? PalpationWords::tr("Left middle finger") : PalpationWords::tr("Left index finger");
}

QString toolName(const catalogue::ExerciseParameters& level, int tool, int tools) {
    if (const auto* palpation = std::get_if<simulation::PalpationParameters>(&level))
        return fingerName(tool, palpation->hands, palpation->fingers);
    return instrumentName(tool, tools);
}

} // namespace chiron::session_report
