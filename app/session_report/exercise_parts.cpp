// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/exercise_parts.h"

#include "app/exercises/elastic_tube/session_report/tube_report_of.h"
#include "app/exercises/object_handling/session_report/handling_report_of.h"
#include "app/exercises/palpation/session_report/palpation_report.h"
#include "app/exercises/sphere_apex/session_report/apex_errors.h"
#include "app/exercises/urethra_insertion/session_report/insertion_profile.h"

namespace chiron::session_report {

namespace {

struct PartsOf {
    const scoring::SessionTrace& trace;
    const catalogue::ExerciseLevel& level;
    report::ExerciseParts& parts;

    void operator()(const simulation::SphereApexParameters&) const { parts.apexErrors = apexErrorsOf(trace); }
    void operator()(const simulation::UrethraInsertionParameters&) const { parts.insertion = insertionProfileOf(trace); }
    void operator()(const simulation::ElasticTubeParameters&) const { parts.tube = tubeReportOf(trace, level); }
    void operator()(const simulation::ObjectHandlingParameters&) const { parts.handling = handlingReportOf(trace, level); }
    void operator()(const simulation::PalpationParameters&) const { parts.palpation = palpationReportOf(trace, level); }
    void operator()(const simulation::ComparisonParameters&) const {} // of studies, which have reports of their own
};

} // namespace

report::ExerciseParts exercisePartsOf(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level) {
    report::ExerciseParts parts;
    std::visit(PartsOf{trace, level, parts}, level.parameters);
    return parts;
}

} // namespace chiron::session_report
