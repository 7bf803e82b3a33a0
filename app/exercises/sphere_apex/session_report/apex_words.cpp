// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/sphere_apex/session_report/apex_words.h"

namespace chiron::session_report {

EndWords apexEnds() {
    return {MarkTexts::tr("Marked the highest point"), MarkTexts::tr("The trial was completed"), MarkTexts::tr("Time was up without a mark"),
            MarkTexts::tr("The trial could no longer be completed"), MarkTexts::tr("The tissue was damaged")};
}

} // namespace chiron::session_report
