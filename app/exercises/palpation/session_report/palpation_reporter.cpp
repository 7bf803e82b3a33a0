// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/session_report/palpation_reporter.h"

#include "app/exercises/palpation/session/palpation_marks.h"
#include "app/exercises/palpation/session_report/finger_words.h"
#include "app/exercises/palpation/session_report/palpation_report.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "session_report/mark_words.h"

namespace chiron::session_report {

namespace {

using session::PlaybackMark;
namespace mark_kinds = session::mark_kinds;

QString sayFound(const PlaybackMark& mark, const QLocale& locale) {
    return MarkTexts::tr("Finding %1 marked").arg(markNumber(mark, locale));
}

QString sayTakenBack(const PlaybackMark& mark, const QLocale& locale) {
    return MarkTexts::tr("Finding %1 taken back").arg(markNumber(mark, locale));
}

QString sayFalseAlarm(const PlaybackMark& mark, const QLocale& locale) {
    return MarkTexts::tr("Finding %1 marked where there was no lump").arg(markNumber(mark, locale));
}

QString sayLumpMissed(const PlaybackMark&, const QLocale&) {
    return MarkTexts::tr("A lump was missed");
}

constexpr MarkWords kPalpationMarks[]{
    {mark_kinds::kFound, &sayFound},
    {mark_kinds::kTakenBack, &sayTakenBack},
    {mark_kinds::kFalseAlarm, &sayFalseAlarm},
    {mark_kinds::kLumpMissed, &sayLumpMissed},
};

} // namespace

std::shared_ptr<const report::ReportSection>
PalpationReporter::section(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel& level) const {
    return palpationSectionOf(trace, level);
}

EndWords PalpationReporter::ends() const {
    return {MarkTexts::tr("Ended"), MarkTexts::tr("The search was reported as done"),
            MarkTexts::tr("Time was up before the search was reported as done"),
            MarkTexts::tr("The search could no longer be completed"),
            MarkTexts::tr("The tissue was damaged")};
}

std::span<const MarkWords> PalpationReporter::marks() const noexcept {
    return kPalpationMarks;
}

QString PalpationReporter::toolName(const catalogue::ExerciseLevel& level, int tool, int) const {
    const auto& p = level.parameters.as<simulation::PalpationParameters>();
    return fingerName(tool, p.hands, p.fingers);
}

} // namespace chiron::session_report
