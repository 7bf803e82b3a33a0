// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/desktop/stage_words.h"

#include <QCoreApplication>
#include <QtMath>
#include <algorithm>
#include <bit>

namespace chiron::desktop {

using simulation::ProcedureStage;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(StageWords)
};

QString inspectionText(const simulation::EndoscopeCues& cues, const StageTelling& telling,
                       const QLocale& locale) {
    const QString seen = locale.toString(landmarksSeen(cues));
    const QString all = locale.toString(cues.landmarks);
    if (telling.guidance && cues.dwell > 0.0)
        return Words::tr("Inspection: %1 of %2 landmarks seen. Hold still").arg(seen, all);
    return Words::tr("Inspection: %1 of %2 landmarks seen").arg(seen, all);
}

} // namespace

QString stageTitle(ProcedureStage stage) {
    switch (stage) {
    case ProcedureStage::outside:
        return Words::tr("Before the entrance");
    case ProcedureStage::insertion:
        return Words::tr("Insertion");
    case ProcedureStage::inspection:
        return Words::tr("Inspection");
    case ProcedureStage::withdrawal:
        return Words::tr("Withdrawal");
    case ProcedureStage::completed:
        return Words::tr("Completed");
    }
    return {};
}

int landmarksSeen(const simulation::EndoscopeCues& cues) {
    return std::popcount(cues.landmarksSeen);
}

QString stageText(const simulation::EndoscopeCues& cues, const StageTelling& telling, const QLocale& locale) {
    switch (cues.stage) {
    case ProcedureStage::outside:
        return Words::tr("Before the entrance: advance into the urethra");
    case ProcedureStage::insertion:
        if (telling.numbers)
            return Words::tr("Insertion: %1 of %2 mm")
                .arg(locale.toString(std::max(0, qRound(cues.depth_m * 1e3))),
                     locale.toString(qRound(telling.goal_m * 1e3)));
        return Words::tr("Insertion: on the way to the goal");
    case ProcedureStage::inspection:
        return inspectionText(cues, telling, locale);
    case ProcedureStage::withdrawal:
        return telling.numbers
                   ? Words::tr("Withdrawal: bring the endoscope out, %1 mm more")
                         .arg(locale.toString(std::max(0, qCeil((cues.depth_m + telling.clear_m) * 1e3))))
                   : Words::tr("Withdrawal: bring the endoscope all the way out");
    case ProcedureStage::completed:
        return Words::tr("Completed");
    }
    return {};
}

double stageProgress(const simulation::EndoscopeCues& cues, const StageTelling& telling) {
    constexpr double kNothing = -1.0;
    switch (cues.stage) {
    case ProcedureStage::insertion:
        return telling.numbers && telling.goal_m > 0.0 ? std::clamp(cues.depth_m / telling.goal_m, 0.0, 1.0)
                                                       : kNothing;
    case ProcedureStage::inspection:
        return telling.guidance ? std::clamp(cues.dwell, 0.0, 1.0) : kNothing;
    case ProcedureStage::withdrawal:
        return telling.numbers && telling.goal_m > 0.0
                   ? std::clamp((telling.goal_m - cues.depth_m) / (telling.goal_m + telling.clear_m), 0.0,
                                1.0)
                   : kNothing;
    case ProcedureStage::outside:
    case ProcedureStage::completed:
        break;
    }
    return kNothing;
}

} // namespace chiron::desktop
