// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/weight_check.h"

#include "core/units.h"
#include "desktop/studies/study_screen.h"
#include "session/study/fidelity_meter.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {

struct WeightCheck {
    Q_DECLARE_TR_FUNCTIONS(WeightCheck)
};

/// The weight of the heaviest object of the conditions on mass; 0 if there is none.
double heaviest_N(const psychophysics::StudyDesign& design) {
    double most_N = 0.0;
    for (const psychophysics::Condition& condition : design.conditions) {
        const auto& stimulus = condition.stimulus;
        if (stimulus.attribute != psychophysics::Attribute::mass)
            continue;
        const double multiple = psychophysics::ranksThree(condition.task) ? 2.0 : 1.0;
        double difference = 0.0;
        for (const double each : stimulus.differences)
            difference = std::max(difference, multiple * each);
        most_N = std::max(most_N, core::kStandardGravity * stimulus.reference * std::pow(10.0, difference));
    }
    return most_N;
}

} // namespace

std::optional<FreezeCheck> weightCheck(const psychophysics::StudyDesign& design, const QLocale& locale) {
    static_assert(session::FidelityMeter::kNearForceLimit == 0.8); // the words below say 80 %
    const double weight_N = heaviest_N(design);
    const double told_N = session::FidelityMeter::kNearForceLimit * design.fidelity.peakForce_N;
    if (weight_N <= told_N)
        return std::nullopt;
    const double least_N = std::ceil(100.0 * weight_N / session::FidelityMeter::kNearForceLimit) / 100.0;
    const auto newtons = [&locale](double force_N) { return locale.toString(force_N, 'f', 2); };
    FreezeCheck check;
    check.name = QStringLiteral("weight");
    check.state = FreezeCheck::State::advice;
    check.title = WeightCheck::tr("Largest force");
    check.words = WeightCheck::tr(
                      "The heaviest object weighs %1 N. From %2 N on, which is 80 % of the largest force of "
                      "a trial, participants are told to pull less hard, so merely holding this object "
                      "would give it away. Allow at least %3 N, or choose lighter objects.")
                      .arg(newtons(weight_N), newtons(told_N), newtons(least_N));
    check.tab = StudyScreen::trialsTab;
    check.field = QStringLiteral("fidelity.peak_force");
    return check;
}

} // namespace chiron::desktop
