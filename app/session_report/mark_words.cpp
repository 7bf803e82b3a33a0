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
    return MarkTexts::tr("The force supervisor stepped in");
}

QString stageText(const std::string& stage) {
    for (const auto& [token, text] : kStages)
        if (stage == token)
            return QCoreApplication::translate("PlaybackMarks", text);
    return MarkTexts::tr("The next stage begins");
}

QString seconds(double span_s, const QLocale& locale) {
    return report::formatValue(span_s, QStringLiteral("s"), locale);
}

} // namespace

QString whatHappened(const session::PlaybackMark& mark, std::string_view exercise, const QLocale& locale) {
    const EndWords end = endWords(exercise);
    const double span_s = mark.end_s - mark.t_s;
    switch (mark.kind) {
    case PlaybackMarkKind::trialStarted:
        return MarkTexts::tr("Trial %1 begins").arg(locale.toString(mark.trial + 1));
    case PlaybackMarkKind::marked:
        return end.marked;
    case PlaybackMarkKind::timedOut:
        return end.timedOut;
    case PlaybackMarkKind::traceEnded:
        return MarkTexts::tr("The trace ended without a mark");
    case PlaybackMarkKind::contact:
        return MarkTexts::tr("In contact for %1").arg(seconds(span_s, locale));
    case PlaybackMarkKind::overLimit:
        return MarkTexts::tr("Over the limit for %1, up to %2")
            .arg(seconds(span_s, locale), report::formatValue(mark.value, QStringLiteral("N"), locale));
    case PlaybackMarkKind::paused:
        return MarkTexts::tr("Paused for %1").arg(seconds(span_s, locale));
    case PlaybackMarkKind::forceStopped:
        return span_s > 0.0
                   ? MarkTexts::tr("The person stopped the force for %1").arg(seconds(span_s, locale))
                   : MarkTexts::tr("The person stopped the force");
    case PlaybackMarkKind::rearmed:
        return MarkTexts::tr("Force re-armed");
    case PlaybackMarkKind::guard:
    case PlaybackMarkKind::fault:
        return guardText(mark.detail);
    case PlaybackMarkKind::ended:
        return MarkTexts::tr("The person ended the session");
    case PlaybackMarkKind::completed:
        return end.completed;
    case PlaybackMarkKind::stageChanged:
        return stageText(mark.detail);
    case PlaybackMarkKind::landmarkSeen:
        return mark.value
                   ? MarkTexts::tr("Landmarks seen: %1").arg(locale.toString(static_cast<int>(*mark.value)))
                   : MarkTexts::tr("A landmark was seen");
    case PlaybackMarkKind::trauma:
        return MarkTexts::tr("Pressed against the wall for %1, up to %2")
            .arg(seconds(span_s, locale), report::formatValue(mark.value, QStringLiteral("N"), locale));
    case PlaybackMarkKind::reversal:
        return MarkTexts::tr("Moved back by %1")
            .arg(report::formatValue(1e3 * mark.value.value_or(0.0), QStringLiteral("mm"), locale));
    case PlaybackMarkKind::offCentre:
        return MarkTexts::tr("Off-centre for %1, up to %2")
            .arg(seconds(span_s, locale),
                 report::formatValue(1e3 * mark.value.value_or(0.0), QStringLiteral("mm"), locale));
    case PlaybackMarkKind::overTorque:
        return MarkTexts::tr("Torque over its limit for %1, up to %2")
            .arg(seconds(span_s, locale),
                 report::formatValue(1e3 * mark.value.value_or(0.0), QStringLiteral("mN·m"), locale));
    case PlaybackMarkKind::grasped:
        return MarkTexts::tr("Took hold");
    case PlaybackMarkKind::released:
        return MarkTexts::tr("Let go");
    case PlaybackMarkKind::slipped:
        return MarkTexts::tr("Slipped out or dropped");
    case PlaybackMarkKind::damaged:
        return end.damaged;
    case PlaybackMarkKind::yielded:
        if (mark.detail == session::kByTorque)
            return MarkTexts::tr("The tissue gave way at a torque of %1")
                .arg(report::formatValue(1e3 * mark.value.value_or(0.0), QStringLiteral("mN·m"), locale));
        return MarkTexts::tr("The tissue gave way at %1")
            .arg(report::formatValue(mark.value, QStringLiteral("N"), locale));
    case PlaybackMarkKind::found:
        return MarkTexts::tr("Finding %1 marked")
            .arg(locale.toString(static_cast<int>(mark.value.value_or(0.0))));
    case PlaybackMarkKind::takenBack:
        return MarkTexts::tr("Finding %1 taken back")
            .arg(locale.toString(static_cast<int>(mark.value.value_or(0.0))));
    case PlaybackMarkKind::failed:
        return end.failed;
    case PlaybackMarkKind::limited:
        return MarkTexts::tr("For %1, less force was felt than the tissue exerted (up to %2)")
            .arg(seconds(span_s, locale), report::formatValue(mark.value, QStringLiteral("N"), locale));
    case PlaybackMarkKind::missed:
        return MarkTexts::tr("Miss: the wrong place was marked");
    case PlaybackMarkKind::falseAlarm:
        return MarkTexts::tr("Finding %1 marked where there was no lump")
            .arg(locale.toString(static_cast<int>(mark.value.value_or(0.0))));
    case PlaybackMarkKind::lumpMissed:
        return MarkTexts::tr("A lump was missed");
    }
    return {};
}

QString markText(const session::PlaybackMark& mark, std::string_view exercise, const QLocale& locale) {
    const QString what = whatHappened(mark, exercise, locale);
    return mark.critical ? MarkTexts::tr("Critical error: %1").arg(what) : what;
}

} // namespace chiron::session_report
