// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/session_report/insertion_words.h"

namespace chiron::session_report {

EndWords insertionEnds() {
    return {MarkTexts::tr("Ended"), MarkTexts::tr("The procedure was completed"), MarkTexts::tr("Time was up before the end of the procedure"),
            MarkTexts::tr("The procedure could no longer be completed"), MarkTexts::tr("The tissue was damaged")};
}

} // namespace chiron::session_report
