// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/session_report/urethra_insertion_reporter.h"

#include "app/exercises/urethra_insertion/session/insertion_marks.h"
#include "app/exercises/urethra_insertion/session_report/insertion_profile.h"
#include "session_report/mark_words.h"

namespace chiron::session_report {

namespace {

using session::PlaybackMark;
namespace mark_kinds = session::mark_kinds;

QString sayLandmark(const PlaybackMark& mark, const QLocale& locale) {
    return mark.value ? MarkTexts::tr("Landmarks seen: %1").arg(markNumber(mark, locale))
                      : MarkTexts::tr("A landmark was seen");
}

QString sayTrauma(const PlaybackMark& mark, const QLocale& locale) {
    return MarkTexts::tr("Trauma event: pressed sideways on the wall for %1, up to %2")
        .arg(markSpan(mark, locale), markValue(mark, QStringLiteral("N"), locale));
}

QString sayReversal(const PlaybackMark& mark, const QLocale& locale) {
    return MarkTexts::tr("Moved back by %1").arg(markThousandths(mark, QStringLiteral("mm"), locale));
}

QString sayOffCentre(const PlaybackMark& mark, const QLocale& locale) {
    return MarkTexts::tr("Off-centre for %1, up to %2")
        .arg(markSpan(mark, locale), markThousandths(mark, QStringLiteral("mm"), locale));
}

QString sayOverTorque(const PlaybackMark& mark, const QLocale& locale) {
    return MarkTexts::tr("Torque over its limit for %1, up to %2")
        .arg(markSpan(mark, locale), markThousandths(mark, QStringLiteral("mN·m"), locale));
}

constexpr MarkWords kInsertionMarks[]{
    {mark_kinds::kLandmarkSeen, &sayLandmark}, {mark_kinds::kTrauma, &sayTrauma},
    {mark_kinds::kReversal, &sayReversal},     {mark_kinds::kOffCentre, &sayOffCentre},
    {mark_kinds::kOverTorque, &sayOverTorque},
};

constexpr StageWords kInsertionStages[]{
    {"insertion", QT_TRANSLATE_NOOP("PlaybackMarks", "The insertion begins")},
    {"inspection", QT_TRANSLATE_NOOP("PlaybackMarks", "The inspection begins")},
    {"withdrawal", QT_TRANSLATE_NOOP("PlaybackMarks", "The withdrawal begins")},
};

} // namespace

std::shared_ptr<const report::ReportSection>
UrethraInsertionReporter::section(const scoring::SessionTrace& trace, const catalogue::ExerciseLevel&) const {
    auto profile = insertionProfileOf(trace);
    return profile ? std::make_shared<report::InsertionSection>(std::move(*profile)) : nullptr;
}

EndWords UrethraInsertionReporter::ends() const {
    return {MarkTexts::tr("Ended"), MarkTexts::tr("The procedure was completed"),
            MarkTexts::tr("Time was up before the end of the procedure"),
            MarkTexts::tr("The procedure could no longer be completed"),
            MarkTexts::tr("The tissue was damaged")};
}

std::span<const MarkWords> UrethraInsertionReporter::marks() const noexcept {
    return kInsertionMarks;
}

std::span<const StageWords> UrethraInsertionReporter::stages() const noexcept {
    return kInsertionStages;
}

} // namespace chiron::session_report
