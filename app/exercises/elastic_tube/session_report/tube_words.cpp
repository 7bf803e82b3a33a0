// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/elastic_tube/session_report/tube_words.h"

namespace chiron::session_report {

EndWords tubeEnds() {
    return {MarkTexts::tr("Ended"), MarkTexts::tr("The tube was held as asked"), MarkTexts::tr("Time was up before the tube was held as asked"),
            MarkTexts::tr("The tube tore: the trial could no longer be completed"), MarkTexts::tr("The tube was stretched too far")};
}

} // namespace chiron::session_report
