// SPDX-License-Identifier: GPL-3.0-or-later
// The exercises that reports and playback speak of: one for each line of exercise_catalogue.h.
#include "app/exercises/elastic_tube/session_report/elastic_tube_reporter.h"
#include "app/exercises/exercise_catalogue.h"
#include "app/exercises/object_handling/session_report/object_handling_reporter.h"
#include "app/exercises/palpation/session_report/palpation_reporter.h"
#include "app/exercises/sphere_apex/session_report/sphere_apex_reporter.h"
#include "app/exercises/urethra_insertion/session_report/urethra_insertion_reporter.h"
#include "session_report/comparison_reporter.h"
#include "session_report/exercise_reporter.h"

#include <array>
#include <span>
#include <tuple>

namespace chiron::session_report {

namespace {

template <class... Exercises>
std::span<const ExerciseReporter* const> reportersOf(exercises::List<Exercises...>) {
    static const std::tuple<typename Exercises::Reporter...> reporters;
    static const auto all = std::apply(
        [](const auto&... reporter) { return std::to_array<const ExerciseReporter*>({&reporter...}); },
        reporters);
    return all;
}

} // namespace

const ExerciseReporter* exerciseReporter(std::string_view id) noexcept {
    for (const ExerciseReporter* reporter : reportersOf(exercises::All{}))
        if (reporter->id() == id)
            return reporter;
    return nullptr;
}

std::shared_ptr<const report::ReportSection> exerciseSectionOf(const scoring::SessionTrace& trace,
                                                               const catalogue::ExerciseLevel& level) {
    const ExerciseReporter* reporter = exerciseReporter(level.exercise);
    return reporter ? reporter->section(trace, level) : nullptr;
}

EndWords endWords(std::string_view exercise) {
    const ExerciseReporter* reporter = exerciseReporter(exercise);
    return reporter ? reporter->ends() : EndWords();
}

QString toolName(const catalogue::ExerciseLevel& level, int tool, int tools) {
    const ExerciseReporter* reporter = exerciseReporter(level.exercise);
    return reporter ? reporter->toolName(level, tool, tools) : instrumentName(tool, tools);
}

} // namespace chiron::session_report
