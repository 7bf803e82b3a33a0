// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/mark_words.h"

#include "report/report_text.h"
#include "session_report/exercise_words.h"

#include <QCoreApplication>
#include <array>
#include <utility>

namespace chiron::session_report {

using session::PlaybackMarkKind;

namespace {

using Words = MarkTexts;

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
constexpr std::array<std::pair<const char*, const char*>, 11> kStages{{
    {"insertion", QT_TRANSLATE_NOOP("PlaybackMarks", "The insertion begins")},
    {"inspection", QT_TRANSLATE_NOOP("PlaybackMarks", "The inspection begins")},
    {"withdrawal", QT_TRANSLATE_NOOP("PlaybackMarks", "The withdrawal begins")},
    {"grasp", QT_TRANSLATE_NOOP("PlaybackMarks", "Step: take hold")},
    {"stretch", QT_TRANSLATE_NOOP("PlaybackMarks", "Step: stretch")},
    {"hold", QT_TRANSLATE_NOOP("PlaybackMarks", "Step: hold still")},
    {"hand_over", QT_TRANSLATE_NOOP("PlaybackMarks", "Step: hand over")},
    {"lift", QT_TRANSLATE_NOOP("PlaybackMarks", "Step: lift")},
    {"carry", QT_TRANSLATE_NOOP("PlaybackMarks", "Step: carry to the target")},
    {"place", QT_TRANSLATE_NOOP("PlaybackMarks", "Step: set down")},
    {"retract", QT_TRANSLATE_NOOP("PlaybackMarks", "Step: hold the tissue back")},
}};
// clang-format on

QString guardText(const std::string& detail) {
    for (const auto& [token, text] : kGuards)
        if (detail == token)
            return QCoreApplication::translate("PlaybackMarks", text);
    return Words::tr("The force supervisor stepped in");
}

QString stageText(const std::string& stage) {
    for (const auto& [token, text] : kStages)
        if (stage == token)
            return QCoreApplication::translate("PlaybackMarks", text);
    return Words::tr("The next stage begins");
}

QString seconds(double span_s, const QLocale& locale) {
    return report::formatValue(span_s, QStringLiteral("s"), locale);
}

} // namespace

QString whatHappened(const session::PlaybackMark& mark, std::string_view exercise, const QLocale& locale) {
    const EndWords end = endWords(exercise);
    const double span_s = mark.end_s - mark.t_s;
    switch (mark.kind) {
    case PlaybackMarkKind::trialStarted: return Words::tr("Trial %1 begins").arg(locale.toString(mark.trial + 1));
    case PlaybackMarkKind::marked: return end.marked;
    case PlaybackMarkKind::timedOut: return end.timedOut;
    case PlaybackMarkKind::traceEnded: return Words::tr("The trace ended without a mark");
    case PlaybackMarkKind::contact: return Words::tr("In contact for %1").arg(seconds(span_s, locale));
    case PlaybackMarkKind::overLimit:
        return Words::tr("Over the limit for %1, up to %2").arg(seconds(span_s, locale), report::formatValue(mark.value, QStringLiteral("N"), locale));
    case PlaybackMarkKind::paused: return Words::tr("Paused for %1").arg(seconds(span_s, locale));
    case PlaybackMarkKind::forceStopped:
        return span_s > 0.0 ? Words::tr("The person stopped the force for %1").arg(seconds(span_s, locale)) : Words::tr("The person stopped the force");
    case PlaybackMarkKind::rearmed: return Words::tr("Force re-armed");
    case PlaybackMarkKind::guard:
    case PlaybackMarkKind::fault: return guardText(mark.detail);
    case PlaybackMarkKind::ended: return Words::tr("The person ended the session");
    case PlaybackMarkKind::completed: return end.completed;
    case PlaybackMarkKind::stageChanged: return stageText(mark.detail);
    case PlaybackMarkKind::landmarkSeen:
        return mark.value ? Words::tr("Landmarks seen: %1").arg(locale.toString(static_cast<int>(*mark.value))) : Words::tr("A landmark was seen");
    case PlaybackMarkKind::trauma:
        return Words::tr("Pressed against the wall for %1, up to %2").arg(seconds(span_s, locale), report::formatValue(mark.value, QStringLiteral("N"), locale));
    case PlaybackMarkKind::reversal:
        return Words::tr("Moved back by %1").arg(report::formatValue(1e3 * mark.value.value_or(0.0), QStringLiteral("mm"), locale));
    case PlaybackMarkKind::offCentre:
        return Words::tr("Off-centre for %1, up to %2").arg(seconds(span_s, locale), report::formatValue(1e3 * mark.value.value_or(0.0), QStringLiteral("mm"), locale));
    case PlaybackMarkKind::overTorque:
        return Words::tr("Torque over its limit for %1, up to %2").arg(seconds(span_s, locale), report::formatValue(1e3 * mark.value.value_or(0.0), QStringLiteral("mN·m"), locale));
    case PlaybackMarkKind::grasped: return Words::tr("Took hold");
    case PlaybackMarkKind::released: return Words::tr("Let go");
    case PlaybackMarkKind::slipped: return Words::tr("Slipped out or dropped");
    case PlaybackMarkKind::damaged: return end.damaged;
    case PlaybackMarkKind::yielded:
        if (mark.detail == session::kByTorque)
            return Words::tr("The tissue gave way at a torque of %1").arg(report::formatValue(1e3 * mark.value.value_or(0.0), QStringLiteral("mN·m"), locale));
        return Words::tr("The tissue gave way at %1").arg(report::formatValue(mark.value, QStringLiteral("N"), locale));
    case PlaybackMarkKind::found: return Words::tr("Finding %1 marked").arg(locale.toString(static_cast<int>(mark.value.value_or(0.0))));
    case PlaybackMarkKind::takenBack: return Words::tr("Finding %1 taken back").arg(locale.toString(static_cast<int>(mark.value.value_or(0.0))));
    case PlaybackMarkKind::failed: return end.failed;
    case PlaybackMarkKind::limited:
        return Words::tr("For %1, less force was felt than the tissue exerted (up to %2)")
            .arg(seconds(span_s, locale), report::formatValue(mark.value, QStringLiteral("N"), locale));
    case PlaybackMarkKind::missed: return Words::tr("Miss: the wrong place was marked");
    case PlaybackMarkKind::falseAlarm: return Words::tr("Finding %1 marked where there was no lump").arg(locale.toString(static_cast<int>(mark.value.value_or(0.0))));
    case PlaybackMarkKind::lumpMissed: return Words::tr("A lump was missed");
    }
    return {};
}

QString markText(const session::PlaybackMark& mark, std::string_view exercise, const QLocale& locale) {
    const QString what = whatHappened(mark, exercise, locale);
    return mark.critical ? Words::tr("Critical error: %1").arg(what) : what;
}

} // namespace chiron::session_report
