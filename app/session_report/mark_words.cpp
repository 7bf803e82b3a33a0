// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/mark_words.h"

#include "report/report_text.h"
#include "session_report/exercise_reporter.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <utility>

namespace chiron::session_report {

using session::PlaybackMark;
namespace mark_kinds = session::mark_kinds;

namespace {

// clang-format off
constexpr std::array<std::pair<const char*, const char*>, 8> kGuards{{
    {"over_velocity", QT_TRANSLATE_NOOP("PlaybackMarks", "Force on hold: the tool moved too fast")},
    {"bad_sample", QT_TRANSLATE_NOOP("PlaybackMarks", "The device sent an invalid sample")},
    {"sample_fault", QT_TRANSLATE_NOOP("PlaybackMarks", "Fault: the device sent too many invalid samples")},
    {"watchdog", QT_TRANSLATE_NOOP("PlaybackMarks", "Force on hold: samples from the device came late")},
    {"watchdog_fault", QT_TRANSLATE_NOOP("PlaybackMarks", "Fault: the device stopped sending data")},
    {"window_frozen", QT_TRANSLATE_NOOP("PlaybackMarks", "Force on hold: the window did not respond")},
    {"passivity", QT_TRANSLATE_NOOP("PlaybackMarks", "Force damped to keep it stable")},
    {"device_fault", QT_TRANSLATE_NOOP("PlaybackMarks", "Fault: reported by the device")},
}};
// clang-format on

/// The words for the end of a trial and for damage, which each exercise has of its own.
constexpr std::pair<session::PlaybackMarkKind, QString EndWords::*> kEnds[]{
    {mark_kinds::kMarked, &EndWords::marked},       {mark_kinds::kTimedOut, &EndWords::timedOut},
    {mark_kinds::kCompleted, &EndWords::completed}, {mark_kinds::kDamaged, &EndWords::damaged},
    {mark_kinds::kFailed, &EndWords::failed},
};

QString sayTrialStarted(const PlaybackMark& mark, const QLocale& locale) {
    return MarkTexts::tr("Trial %1 begins").arg(locale.toString(mark.trial + 1));
}

QString sayTraceEnded(const PlaybackMark&, const QLocale&) {
    return MarkTexts::tr("The trace ended without a mark");
}

QString sayContact(const PlaybackMark& mark, const QLocale& locale) {
    return MarkTexts::tr("In contact for %1").arg(markSpan(mark, locale));
}

QString sayOverLimit(const PlaybackMark& mark, const QLocale& locale) {
    return MarkTexts::tr("Over the force limit for %1, up to %2")
        .arg(markSpan(mark, locale), markValue(mark, QStringLiteral("N"), locale));
}

QString sayPaused(const PlaybackMark& mark, const QLocale& locale) {
    return MarkTexts::tr("Paused for %1").arg(markSpan(mark, locale));
}

QString sayForceStopped(const PlaybackMark& mark, const QLocale& locale) {
    return mark.end_s - mark.t_s > 0.0
               ? MarkTexts::tr("The person stopped the force for %1").arg(markSpan(mark, locale))
               : MarkTexts::tr("The person stopped the force");
}

QString sayRearmed(const PlaybackMark&, const QLocale&) {
    return MarkTexts::tr("Force re-armed");
}

QString sayGuard(const PlaybackMark& mark, const QLocale&) {
    for (const auto& [token, text] : kGuards)
        if (mark.detail == token)
            return QCoreApplication::translate("PlaybackMarks", text);
    return MarkTexts::tr("The force supervisor stepped in");
}

QString sayEnded(const PlaybackMark&, const QLocale&) {
    return MarkTexts::tr("The person ended the session");
}

QString sayGrasped(const PlaybackMark&, const QLocale&) {
    return MarkTexts::tr("Took hold");
}

QString sayReleased(const PlaybackMark&, const QLocale&) {
    return MarkTexts::tr("Let go");
}

QString saySlipped(const PlaybackMark&, const QLocale&) {
    return MarkTexts::tr("Slipped out or dropped");
}

QString sayYielded(const PlaybackMark& mark, const QLocale& locale) {
    if (mark.detail == session::kByTorque)
        return MarkTexts::tr("The tissue gave way at a torque of %1")
            .arg(markThousandths(mark, QStringLiteral("mN·m"), locale));
    return MarkTexts::tr("The tissue gave way at %1").arg(markValue(mark, QStringLiteral("N"), locale));
}

QString sayLimited(const PlaybackMark& mark, const QLocale& locale) {
    return MarkTexts::tr("For %1, less force was felt than the tissue exerted (up to %2)")
        .arg(markSpan(mark, locale), markValue(mark, QStringLiteral("N"), locale));
}

constexpr MarkWords kShared[]{
    {mark_kinds::kTrialStarted, &sayTrialStarted},
    {mark_kinds::kTraceEnded, &sayTraceEnded},
    {mark_kinds::kContact, &sayContact},
    {mark_kinds::kOverLimit, &sayOverLimit},
    {mark_kinds::kPaused, &sayPaused},
    {mark_kinds::kForceStopped, &sayForceStopped},
    {mark_kinds::kRearmed, &sayRearmed},
    {mark_kinds::kGuard, &sayGuard},
    {mark_kinds::kFault, &sayGuard},
    {mark_kinds::kEnded, &sayEnded},
    {mark_kinds::kGrasped, &sayGrasped},
    {mark_kinds::kReleased, &sayReleased},
    {mark_kinds::kSlipped, &saySlipped},
    {mark_kinds::kYielded, &sayYielded},
    {mark_kinds::kLimited, &sayLimited},
};

/// The words of the first row for this kind of mark; empty if there is none.
QString wordsIn(std::span<const MarkWords> rows, const PlaybackMark& mark, const QLocale& locale) {
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&mark](const MarkWords& words) { return words.kind == mark.kind; });
    return row == rows.end() ? QString() : row->say(mark, locale);
}

QString stageText(const ExerciseReporter* reporter, const std::string& stage) {
    if (reporter != nullptr)
        for (const StageWords& words : reporter->stages())
            if (words.stage == stage)
                return QCoreApplication::translate("PlaybackMarks", words.text);
    return MarkTexts::tr("The next stage begins");
}

// clang-format off
constexpr StageWords kLaparoscopySteps[]{
    {"grasp", QT_TRANSLATE_NOOP("PlaybackMarks", "Step: take hold")},
    {"stretch", QT_TRANSLATE_NOOP("PlaybackMarks", "Step: stretch")},
    {"hold", QT_TRANSLATE_NOOP("PlaybackMarks", "Step: hold still")},
    {"hand_over", QT_TRANSLATE_NOOP("PlaybackMarks", "Step: hand over")},
    {"lift", QT_TRANSLATE_NOOP("PlaybackMarks", "Step: lift")},
    {"carry", QT_TRANSLATE_NOOP("PlaybackMarks", "Step: carry to the target")},
    {"place", QT_TRANSLATE_NOOP("PlaybackMarks", "Step: set down")},
    {"retract", QT_TRANSLATE_NOOP("PlaybackMarks", "Step: hold the tissue back")},
};
// clang-format on

} // namespace

QString markSpan(const PlaybackMark& mark, const QLocale& locale) {
    return report::formatValue(mark.end_s - mark.t_s, QStringLiteral("s"), locale);
}

QString markValue(const PlaybackMark& mark, const QString& unit, const QLocale& locale) {
    return report::formatValue(mark.value, unit, locale);
}

QString markThousandths(const PlaybackMark& mark, const QString& unit, const QLocale& locale) {
    return report::formatValue(1e3 * mark.value.value_or(0.0), unit, locale);
}

QString markNumber(const PlaybackMark& mark, const QLocale& locale) {
    return locale.toString(static_cast<int>(mark.value.value_or(0.0)));
}

std::span<const StageWords> laparoscopySteps() noexcept {
    return kLaparoscopySteps;
}

QString whatHappened(const PlaybackMark& mark, std::string_view exercise, const QLocale& locale) {
    const ExerciseReporter* reporter = exerciseReporter(exercise);
    for (const auto& [kind, words] : kEnds)
        if (mark.kind == kind)
            return reporter != nullptr ? reporter->ends().*words : QString();
    if (mark.kind == mark_kinds::kStageChanged)
        return stageText(reporter, mark.detail);
    if (const QString shared = wordsIn(kShared, mark, locale); !shared.isEmpty())
        return shared;
    return reporter != nullptr ? wordsIn(reporter->marks(), mark, locale) : QString();
}

QString markText(const PlaybackMark& mark, std::string_view exercise, const QLocale& locale) {
    const QString what = whatHappened(mark, exercise, locale);
    return mark.critical ? MarkTexts::tr("Critical error: %1").arg(what) : what;
}

} // namespace chiron::session_report
