// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/tool_words.h"

#include <QCoreApplication>

namespace chiron::session_report {

namespace {

struct GraspWords {
    Q_DECLARE_TR_FUNCTIONS(GraspWords)
};

} // namespace

QString instrumentName(int tool, int tools) {
    if (tools <= 1)
        return GraspWords::tr("Instrument");
    return tool == 0   ? GraspWords::tr("Right instrument")
           : tool == 1 ? GraspWords::tr("Left instrument")
                       : GraspWords::tr("Instrument %1").arg(tool + 1);
}

} // namespace chiron::session_report
