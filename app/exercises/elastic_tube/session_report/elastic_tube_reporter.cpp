// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/elastic_tube/session_report/elastic_tube_reporter.h"

#include "app/exercises/elastic_tube/session_report/tube_report_of.h"
#include "session_report/mark_words.h"

namespace chiron::session_report {

std::shared_ptr<const report::ReportSection>
ElasticTubeReporter::section(const scoring::SessionTrace& trace,
                             const catalogue::ExerciseLevel& level) const {
    return std::make_shared<report::TubeSection>(tubeReportOf(trace, level));
}

EndWords ElasticTubeReporter::ends() const {
    return {MarkTexts::tr("Ended"), MarkTexts::tr("The tube was held as asked"),
            MarkTexts::tr("Time was up before the tube was held as asked"),
            MarkTexts::tr("The tube tore: the trial could no longer be completed"),
            MarkTexts::tr("The tube was stretched too far")};
}

std::span<const StageWords> ElasticTubeReporter::stages() const noexcept {
    return laparoscopySteps();
}

} // namespace chiron::session_report
