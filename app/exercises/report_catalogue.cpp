// SPDX-License-Identifier: GPL-3.0-or-later
// The exercises that have something of their own in a report of a session: a line each.
#include "app/exercises/elastic_tube/session_report/tube_report_of.h"
#include "app/exercises/object_handling/session_report/handling_report_of.h"
#include "app/exercises/palpation/session_report/palpation_report.h"
#include "app/exercises/sphere_apex/session_report/apex_errors.h"
#include "app/exercises/urethra_insertion/session_report/insertion_profile.h"
#include "session_report/exercise_section.h"

#include <array>

namespace chiron::session_report {

namespace {

struct SectionLine {
    const char* exercise;
    std::shared_ptr<const report::ReportSection> (*make)(const scoring::SessionTrace&, const catalogue::ExerciseLevel&);
};

constexpr std::array kReportCatalogue{
    SectionLine{"sphere_apex", &apexSectionOf},
    SectionLine{"urethra_insertion", &insertionSectionOf},
    SectionLine{"elastic_tube", &tubeSectionOf},
    SectionLine{"object_handling", &handlingSectionOf},
    SectionLine{"palpation", &palpationSectionOf},
}; // comparisons have the reports of their studies

} // namespace

std::shared_ptr<const report::ReportSection> exerciseSectionOf(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level) {
    for (const SectionLine& line : kReportCatalogue)
        if (level.exercise == line.exercise)
            return line.make(trace, level);
    return nullptr;
}

} // namespace chiron::session_report
