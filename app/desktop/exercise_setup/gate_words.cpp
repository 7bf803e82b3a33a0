// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/exercise_setup/gate_words.h"

#include "desktop/plots/metric_words.h"
#include "scoring/metric_catalogue.h"

#include <QCoreApplication>

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
    return Words::tr("%1 %2").arg(number, QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size())));
}

} // namespace

QString gateInWords(const scoring::Gate& gate, const QLocale& locale) {
    const scoring::MetricDefinition* metric = scoring::findMetric(gate.metric);
    const std::string_view unit = metric ? metric->unit : std::string_view();
    const QString title = metricTitle(QString::fromStdString(gate.metric));
    if (gate.minimum && gate.maximum)
        return Words::tr("%1: from %2 to %3").arg(title, withUnit(*gate.minimum, unit, locale), withUnit(*gate.maximum, unit, locale));
    if (gate.minimum)
        return Words::tr("%1: at least %2").arg(title, withUnit(*gate.minimum, unit, locale));
    if (gate.maximum == 0.0 && unit == "count")
        return Words::tr("%1: none").arg(title);
    return Words::tr("%1: at most %2").arg(title, withUnit(gate.maximum.value_or(0.0), unit, locale));
}

} // namespace chiron::desktop
