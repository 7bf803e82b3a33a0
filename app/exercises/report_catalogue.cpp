// SPDX-License-Identifier: GPL-3.0-or-later
// The exercise-specific words and sections of reports and playback, one line per exercise.
#include "app/exercises/elastic_tube/session_report/tube_report_of.h"
#include "app/exercises/object_handling/session_report/handling_report_of.h"
#include "app/exercises/palpation/session_report/finger_words.h"
#include "app/exercises/palpation/session_report/palpation_report.h"
#include "app/exercises/sphere_apex/session_report/apex_errors.h"
#include "app/exercises/urethra_insertion/session_report/insertion_profile.h"
#include "session_report/comparison_words.h"
#include "session_report/exercise_section.h"
#include "session_report/exercise_words.h"
#include "session_report/tool_words.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace chiron::session_report {

namespace {

using MakeSection = std::shared_ptr<const report::ReportSection> (*)(const scoring::SessionTrace&,
                                                                     const catalogue::ExerciseLevel&);
using NameTool = QString (*)(const catalogue::ExerciseLevel&, int tool, int tools);

struct ReportLine {
    const char* exercise;
    MakeSection section; ///< null: the exercise has no section of its own
    EndWords (*ends)();
    NameTool tool;
};

QString instrumentOf(const catalogue::ExerciseLevel&, int tool, int tools) {
    return instrumentName(tool, tools);
}

constexpr std::array kReportCatalogue{
    ReportLine{"sphere_apex", &apexSectionOf, &apexEnds, &instrumentOf},
    ReportLine{"urethra_insertion", &insertionSectionOf, &insertionEnds, &instrumentOf},
    ReportLine{"elastic_tube", &tubeSectionOf, &tubeEnds, &instrumentOf},
    ReportLine{"object_handling", &handlingSectionOf, &handlingEnds, &instrumentOf},
    ReportLine{"palpation", &palpationSectionOf, &palpationEnds, &fingerNameOf},
    // No section: its studies have reports of their own.
    ReportLine{"comparison", nullptr, &comparisonEnds, &instrumentOf},
};

const ReportLine* lineOf(std::string_view exercise) {
    const auto* found =
        std::find_if(kReportCatalogue.begin(), kReportCatalogue.end(),
                     [exercise](const ReportLine& line) { return exercise == line.exercise; });
    return found == kReportCatalogue.end() ? nullptr : found;
}

} // namespace

std::shared_ptr<const report::ReportSection> exerciseSectionOf(const scoring::SessionTrace& trace,
                                                               const catalogue::ExerciseLevel& level) {
    const ReportLine* line = lineOf(level.exercise);
    return line && line->section ? line->section(trace, level) : nullptr;
}

EndWords endWords(std::string_view exercise) {
    const ReportLine* line = lineOf(exercise);
    return line ? line->ends() : EndWords();
}

QString toolName(const catalogue::ExerciseLevel& level, int tool, int tools) {
    const ReportLine* line = lineOf(level.exercise);
    return line ? line->tool(level, tool, tools) : instrumentName(tool, tools);
}

} // namespace chiron::session_report
