// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/object_handling/session_report/handling_words.h"

namespace chiron::session_report {

EndWords handlingEnds() {
    return {MarkTexts::tr("Ended"), MarkTexts::tr("An object was set down in the target"), MarkTexts::tr("Time was up before an object was set down in the target"),
            MarkTexts::tr("The trial could no longer be completed"), MarkTexts::tr("The object was squeezed too hard")};
}

} // namespace chiron::session_report
