// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/training_words.h"

#include "desktop/station/station_words.h"
#include "desktop/training/felt_words.h"

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
    if (name == "hesitant")
        return Words::tr("Hesitant (draws back)");
    if (name == "unsafe")
        return Words::tr("Unsafe (presses too hard)");
    return QString::fromStdString(name);
}

QString deviceTitle(const TrainingPlan& plan) {
    switch (plan.driver->movedBy) {
    case devices::MovedBy::scriptedOperator: {
        const QString who = operatorTitle(plan.operatorName.toStdString());
        const auto kind = session::exerciseKind(plan.exercise.toStdString());
        // No class: the driver renders force, but nobody holds it.
        return Words::tr("Demonstration (%1). %2")
            .arg(who, StationWords::device(*plan.driver, kind ? (*kind)->mechanism() : std::string_view()));
    }
    case devices::MovedBy::recording:
        return Words::tr("Replayed file %1: force shown, not felt").arg(QFileInfo(plan.traceFile).fileName());
    case devices::MovedBy::person:
        break;
    }
    const QString name = StationWords::driver(*plan.driver);
    if (plan.driver->name.empty())
        return name; // the command line's title already says whether force is felt
    return felt_words::device(name, plan.feltByPerson());
}

QString deviceIcon(devices::MovedBy movedBy) {
    switch (movedBy) {
    case devices::MovedBy::scriptedOperator:
        return QStringLiteral("media-playback-start");
    case devices::MovedBy::recording:
        return QStringLiteral("document-open");
    case devices::MovedBy::person:
        break;
    }
    return QStringLiteral("input-mouse");
}

QString keysInWords(bool ownHand, session::PointerTool tool, int tools, devices::HandKind hand) {
    if (!ownHand)
        return Words::tr("You are watching. Space: pause or continue. Esc: stop.");
    if (hand == devices::HandKind::handle)
        return tool == session::PointerTool::point
                   ? Words::tr(
                         "Move: with the handle. Mark: button of the handle or Enter. Space: pause. Esc: "
                         "stop force. F5: start again.")
                   : Words::tr("Move: with the handle. Space: pause. Esc: stop force. F5: start again.");
    if (tool == session::PointerTool::endoscope)
        return Words::tr(
            "Advance and withdraw: wheel, W and S, or Page Up and Page Down. Turn: mouse or arrow keys. Move "
            "sideways: the same "
            "with the right button or Shift. Roll: Q and E. Space: pause, frees the pointer. Esc: stop "
            "force. F5: start again.");
    if (tool == session::PointerTool::grasper && tools == 2)
        return Words::tr("Move: mouse or arrow keys. Lower and raise: wheel, right button and drag, or Page "
                         "Down and Page Up. Close the jaw: "
                         "hold the left button or G. Open it: the same with Shift, or H. Instrument: 1 is "
                         "the right one, 2 the left one. "
                         "Space: pause, frees the pointer. Esc: stop force. F5: start again.");
    if (tool == session::PointerTool::grasper && tools > 2)
        return Words::tr("Move: mouse or arrow keys. Lower and raise: wheel, right button and drag, or Page "
                         "Down and Page Up. Close the jaw: "
                         "hold the left button or G. Open it: the same with Shift, or H. Instrument: 1 to 4. "
                         "Space: pause, frees the pointer. Esc: stop force. F5: start again.");
    if (tool == session::PointerTool::grasper)
        return Words::tr("Move: mouse or arrow keys. Lower and raise: wheel, right button and drag, or Page "
                         "Down and Page Up. Close the jaw: "
                         "hold the left button or G. Open it: the same with Shift, or H. "
                         "Space: pause, frees the pointer. Esc: stop force. F5: start again.");
    return Words::tr("Move: mouse or arrow keys. Lower and raise: wheel, right button and drag, or Page Down "
                     "and Page Up. Mark: click or "
                     "Enter. Space: pause, frees the pointer. Esc: stop force. F5: start again.");
}

QString activeToolInWords(int tool, int tools) {
    if (tools == 2)
        return tool == 0 ? Words::tr("You move the right instrument (1)")
                         : Words::tr("You move the left instrument (2)");
    return Words::tr("You move instrument %1 of %2").arg(tool + 1).arg(tools);
}

} // namespace chiron::desktop
