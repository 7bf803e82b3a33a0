// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/training_words.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace chiron::desktop {

namespace {
struct Words {
    Q_DECLARE_TR_FUNCTIONS(TrainingWords)
};
} // namespace

QString operatorTitle(const std::string& name) {
    if (name == "expert")
        return Words::tr("Expert");
    if (name == "intermediate")
        return Words::tr("Intermediate");
    if (name == "novice")
        return Words::tr("Novice");
    if (name == "unsafe")
        return Words::tr("Unsafe (presses too hard)");
    return QString::fromStdString(name);
}

QString deviceTitle(const TrainingPlan& plan) {
    switch (plan.device) {
    case PlanDevice::demonstration:
        return Words::tr("Demonstration on the simulated gimbal (%1): shown, not felt").arg(operatorTitle(plan.operatorName.toStdString()));
    case PlanDevice::trace:
        return Words::tr("Replayed file %1: shown, not felt").arg(QFileInfo(plan.traceFile).fileName());
    case PlanDevice::mouse:
        break;
    }
    return Words::tr("Mouse and keyboard: shown, not felt");
}

QString deviceIcon(PlanDevice device) {
    switch (device) {
    case PlanDevice::demonstration:
        return QStringLiteral("media-playback-start");
    case PlanDevice::trace:
        return QStringLiteral("document-open");
    case PlanDevice::mouse:
        break;
    }
    return QStringLiteral("input-mouse");
}

QString keysInWords(bool ownHand) {
    if (!ownHand)
        return Words::tr("You are watching. Space: pause or go on. Esc: stop.");
    return Words::tr("Move: mouse or arrow keys. Lower and raise: wheel, right button and drag, or Page Down and Page Up. Mark: click or "
                     "Enter. Space: pause, frees the pointer. Esc: stop force.");
}

} // namespace chiron::desktop
