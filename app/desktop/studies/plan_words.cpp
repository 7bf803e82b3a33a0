// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/plan_words.h"

#include <QCoreApplication>

namespace chiron::desktop {

namespace {
struct PlanWords {
    Q_DECLARE_TR_FUNCTIONS(PlanWords)
};
} // namespace

QString runsWithoutValueWords(const psychophysics::ConditionPlan& plan, const QLocale& locale) {
    const QString runs = locale.toString(plan.runs);
    if (plan.withoutValue.value_or(0) == 0)
        return PlanWords::tr("All of %1 simulated runs gave a usable value.").arg(runs);
    const QString said =
        PlanWords::tr(
            "%n of %1 simulated run(s) gave no usable value; such runs are left out of group values.",
            nullptr, *plan.withoutValue)
            .arg(runs);
    return plan.trialsForValues == 0
               ? said
               : said + QLatin1Char(' ') +
                     PlanWords::tr(
                         "With about %1 trials or more, fewer than 1 run in 20 gives no usable value.")
                         .arg(locale.toString(plan.trialsForValues));
}

} // namespace chiron::desktop
