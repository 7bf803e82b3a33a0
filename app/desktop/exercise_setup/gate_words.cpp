// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/exercise_setup/gate_words.h"

#include "desktop/exercise_face.h"
#include "scoring/metric_catalogue.h"
#include "session/exercise_kind.h"
#include "session/level_limits.h"
#include "session_report/metric_words.h"

#include <algorithm>

namespace chiron::desktop {

namespace {

QString withUnit(double value, std::string_view unit, const QLocale& locale) {
    const QString number = locale.toString(value, 'g', 6);
    if (unit.empty() || unit == "count")
        return number;
    if (unit == "% of R")
        return GateTexts::tr("%1 % of the radius").arg(number);
    return GateTexts::tr("%1 %2").arg(number,
                                      QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size())));
}

/// A pass mark on the time over the force limit is redundant if another pass mark forbids a smaller force
/// altogether.
bool isImplied(const scoring::Gate& gate, const catalogue::ExerciseLevel& level) {
    const auto kind = session::exerciseKind(level.exercise);
    return gate.metric == "force_time_over_limit" && kind &&
           session::levelLimits(level).force_N < (*kind)->forceLimit_N(level);
}

QString inLevel(const scoring::Gate& gate, const catalogue::ExerciseLevel& level, const QLocale& locale) {
    const std::optional<double> limit_N = session::limitBehind(level, gate);
    if (!limit_N) {
        const auto kind = session::exerciseKind(level.exercise);
        return gateInWords(gate, locale, kind ? (*kind)->trialCount(level) : 1);
    }
    const int more_percent = qRound(100.0 * (*gate.maximum / *limit_N - 1.0));
    return GateTexts::tr("%1: at most %2 N, with %3 % more for the time it takes to react")
        .arg(session_report::metricTitle(QString::fromStdString(gate.metric)),
             locale.toString(*limit_N, 'g', 3), locale.toString(more_percent));
}

} // namespace

QStringList gatesInWords(const catalogue::ExerciseLevel& level, const QLocale& locale) {
    QStringList words;
    for (const scoring::Gate& gate : level.gates)
        if (!isImplied(gate, level))
            words << inLevel(gate, level, locale);
    return words;
}

QStringList limitsInWords(const catalogue::ExerciseLevel& level, const QLocale& locale) {
    const session::LevelLimits limits = session::levelLimits(level);
    QStringList words{GateTexts::tr("Force limit: %1 N").arg(locale.toString(limits.force_N, 'g', 3))};
    if (const auto face = exerciseFace(level.exercise))
        words << (*face)->limitWords(limits, locale);
    return words;
}

QString gateInWords(const scoring::Gate& gate, const QLocale& locale, int trials) {
    const scoring::MetricDefinition* metric = scoring::findMetric(gate.metric);
    const std::string_view unit = metric ? metric->unit : std::string_view();
    const QString title = session_report::metricTitle(QString::fromStdString(gate.metric));
    if (gate.minimum && gate.maximum)
        return GateTexts::tr("%1: from %2 to %3")
            .arg(title, withUnit(*gate.minimum, unit, locale), withUnit(*gate.maximum, unit, locale));
    if (gate.minimum && scoring::asksForAll(*gate.minimum, unit)) {
        const QString wholly = session_report::metricWholly(QString::fromStdString(gate.metric));
        if (wholly.isEmpty())
            return GateTexts::tr("%1: %2").arg(title, withUnit(*gate.minimum, unit, locale));
        return trials > 1 ? GateTexts::tr("%1, in every trial").arg(wholly) : wholly;
    }
    if (gate.minimum)
        return GateTexts::tr("%1: at least %2").arg(title, withUnit(*gate.minimum, unit, locale));
    if (gate.maximum == 0.0 && unit == "count")
        return GateTexts::tr("%1: none").arg(title);
    if (gate.maximum == 0.0)
        return GateTexts::tr("%1: %2").arg(title, withUnit(0.0, unit, locale));
    return GateTexts::tr("%1: at most %2").arg(title, withUnit(gate.maximum.value_or(0.0), unit, locale));
}

} // namespace chiron::desktop
