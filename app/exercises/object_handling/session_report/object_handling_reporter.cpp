// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/object_handling/session_report/object_handling_reporter.h"

#include "app/exercises/object_handling/session_report/handling_report_of.h"
#include "session_report/mark_words.h"

namespace chiron::session_report {

std::shared_ptr<const report::ReportSection>
ObjectHandlingReporter::section(const scoring::SessionTrace& trace,
                                const catalogue::ExerciseLevel& level) const {
    return std::make_shared<report::HandlingSection>(handlingReportOf(trace, level));
}

EndWords ObjectHandlingReporter::ends() const {
    return {MarkTexts::tr("Ended"), MarkTexts::tr("An object was set down in the target"),
            MarkTexts::tr("Time was up before an object was set down in the target"),
            MarkTexts::tr("The trial could no longer be completed"),
            MarkTexts::tr("The object was squeezed too hard")};
}

std::span<const StageWords> ObjectHandlingReporter::stages() const noexcept {
    return laparoscopySteps();
}

} // namespace chiron::session_report
