// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/sphere_apex/session_report/sphere_apex_reporter.h"

#include "app/exercises/sphere_apex/session/apex_marks.h"
#include "app/exercises/sphere_apex/session_report/apex_errors.h"

namespace chiron::session_report {

namespace {

QString sayMissed(const session::PlaybackMark&, const QLocale&) {
    return MarkTexts::tr("Miss: the wrong place was marked");
}

constexpr MarkWords kApexMarks[]{{session::mark_kinds::kMissed, &sayMissed}};

} // namespace

std::shared_ptr<const report::ReportSection>
SphereApexReporter::section(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel&) const {
    return std::make_shared<report::ApexSection>(apexErrorsOf(trace));
}

EndWords SphereApexReporter::ends() const {
    return {MarkTexts::tr("Marked the highest point"), MarkTexts::tr("The trial was completed"),
            MarkTexts::tr("Time was up without a mark"),
            MarkTexts::tr("The trial could no longer be completed"), MarkTexts::tr("The tissue was damaged")};
}

std::span<const MarkWords> SphereApexReporter::marks() const noexcept {
    return kApexMarks;
}

} // namespace chiron::session_report
