// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/exercise_setup/gate_words.h"

#include "desktop/plots/metric_words.h"
#include "scoring/metric_catalogue.h"
#include "session/exercise_kind.h"
#include "session/level_limits.h"

#include <QCoreApplication>
#include <algorithm>

namespace chiron::desktop {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(GateWords)
};

QString withUnit(double value, std::string_view unit, const QLocale& locale) {
    const QString number = locale.toString(value, 'g', 6);
    if (unit.empty() || unit == "count")
        return number;
    if (unit == "% of R")
        return Words::tr("%1 % of the radius").arg(number);
    return Words::tr("%1 %2").arg(number,
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
    if (!limit_N)
        return gateInWords(gate, locale);
    const int more_percent = qRound(100.0 * (*gate.maximum / *limit_N - 1.0));
    return Words::tr("%1: at most %2 N, with %3 % more for the time it takes to react")
        .arg(metricTitle(QString::fromStdString(gate.metric)), locale.toString(*limit_N, 'g', 3),
             locale.toString(more_percent));
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
    const auto newtons = [&locale](double value_N) { return locale.toString(value_N, 'g', 3); };
    QStringList words{Words::tr("Force limit: %1 N").arg(newtons(limits.force_N))};
    if (limits.squeeze_N)
        words << Words::tr("Squeeze: %1 N at most").arg(newtons(*limits.squeeze_N));
    if (limits.lateral_N)
        words << Words::tr("Force across the canal: %1 N at most").arg(newtons(*limits.lateral_N));
    if (limits.retraction_N)
        words << Words::tr("Pull on the fold: %1 N at most").arg(newtons(*limits.retraction_N));
    if (limits.placement_mm)
        words << Words::tr("At the end: %1 mm from the middle of the ring at most, on average")
                     .arg(locale.toString(*limits.placement_mm, 'g', 3));
    return words;
}

QString gateInWords(const scoring::Gate& gate, const QLocale& locale) {
    const scoring::MetricDefinition* metric = scoring::findMetric(gate.metric);
    const std::string_view unit = metric ? metric->unit : std::string_view();
    const QString title = metricTitle(QString::fromStdString(gate.metric));
    if (gate.minimum && gate.maximum)
        return Words::tr("%1: from %2 to %3")
            .arg(title, withUnit(*gate.minimum, unit, locale), withUnit(*gate.maximum, unit, locale));
    if (gate.minimum)
        return Words::tr("%1: at least %2").arg(title, withUnit(*gate.minimum, unit, locale));
    if (gate.maximum == 0.0 && unit == "count")
        return Words::tr("%1: none").arg(title);
    return Words::tr("%1: at most %2").arg(title, withUnit(gate.maximum.value_or(0.0), unit, locale));
}

} // namespace chiron::desktop
