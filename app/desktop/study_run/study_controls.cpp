// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_run/study_controls.h"

#include "session/study/participant_view.h"

#include <QCoreApplication>

namespace chiron::desktop {

namespace {

using psychophysics::Attribute;
using psychophysics::Task;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(StudyControls)
};

ControlHint moveHint(const StudyHand& hand) {
    return hand.pointer ? ControlHint{Pictogram::moveMouse, Words::tr("Move"),
                                      Words::tr("Move the mouse, or use the arrow keys.")}
                        : ControlHint{Pictogram::moveStylus, Words::tr("Move"),
                                      Words::tr("Take the handle and move it over the objects.")};
}

ControlHint exploreHint(Attribute attribute, const StudyHand& hand, const QString& letGo) {
    if (session::isTakenHold(attribute)) {
        const QString pull =
            hand.pointer
                ? Words::tr("Lower the tool into the ring: roll the wheel towards you, or hold Page Down. To "
                            "pull, roll it away from you, or hold Page Up.")
                : Words::tr("Lower the tip into the ring, then raise the handle.");
        return {hand.pointer ? Pictogram::wheelAway : Pictogram::pressStylus, Words::tr("Take hold and pull"),
                pull + QLatin1Char(' ') + letGo};
    }
    return hand.pointer
               ? ControlHint{Pictogram::wheelTowards, Words::tr("Press"),
                             Words::tr("Roll the wheel towards you, or hold Page Down. To raise, roll it "
                                       "away from you, or hold Page Up.")}
               : ControlHint{
                     Pictogram::pressStylus, Words::tr("Press"),
                     Words::tr("Push the tip into the object, or stroke it. Raise the handle to let go.")};
}

QString answerHow(Task task, Attribute attribute, const StudyHand& hand) {
    if (attribute == Attribute::apex)
        return hand.pointer
                   ? Words::tr("Click, or press Enter, while the tool is at the place.")
                   : Words::tr("Press the button of the handle, or Enter, while the tip is at the place.");
    switch (task) {
    case Task::rank3:
        return Words::tr(
            "Press 1, 2 or 3 from least to most, then Enter. Backspace takes the last one back.");
    case Task::rank3Ties:
        return Words::tr("Press 1, 2 or 3 from least to most, with = before one that equals the last, then "
                         "Enter. Backspace takes the last one back.");
    case Task::sameDifferent:
        return Words::tr("Press 1 for the same, 2 for different.");
    case Task::yesNo:
        return Words::tr("Press Y for yes, N for no.");
    case Task::adjustment:
        return Words::tr("Press + and − until both seem the same, then Enter.");
    case Task::magnitude:
        return Words::tr("Type a number, then press Enter.");
    default:
        if (hand.pointer)
            return psychophysics::placesOf(task) == 2
                       ? Words::tr("Press the number of the object: 1 or 2.")
                       : Words::tr("Press the number of the object: 1, 2 or 3.");
        return Words::tr("Press the number of the object, or the button of the handle while you touch it.");
    }
}

} // namespace

QString letGoSentence(Attribute attribute, const LetGo& letGo, const QLocale& locale) {
    constexpr double kMm = 1000.0;
    if (attribute == Attribute::mass)
        return Words::tr("To let go, set the object down and press it lightly onto the table, then raise the "
                         "tool.");
    return letGo.drawn ? Words::tr("To let go, lower the tool below the dashed line, then raise it.")
                       : Words::tr("To let go, lower the tool %1 mm below the ring, then raise it.")
                             .arg(locale.toString(letGo.below_m * kMm, 'g', 3));
}

std::vector<ControlHint> studyControls(Task task, Attribute attribute, const StudyHand& hand,
                                       const LetGo& letGo, const QLocale& locale) {
    const bool click = attribute == Attribute::apex;
    const Pictogram answer = hand.pointer ? (click ? Pictogram::leftClick : Pictogram::keys)
                             : click      ? Pictogram::stylusButton
                                          : Pictogram::keys;
    return {moveHint(hand),
            exploreHint(attribute, hand, letGoSentence(attribute, letGo, locale)),
            {answer, Words::tr("Answer"), answerHow(task, attribute, hand)}};
}

QString studyKeys(Task, Attribute, const StudyHand& hand) {
    const QString always = Words::tr("Space pauses. Esc stops force at once, and R brings it back slowly; "
                                     "Esc again asks whether to stop.");
    return hand.pointer ? Words::tr("%1 T frees the pointer, so that the answers can be clicked as well; a "
                                    "click in the scene takes it back and does not count as an answer.")
                              .arg(always)
                        : Words::tr("%1 The answers can be clicked as well.").arg(always);
}

std::vector<int> studyMovementKeys(const StudyHand& hand) {
    return movementKeys(session::PointerTool::point,
                        hand.pointer ? devices::HandKind::mouseAndKeyboard : devices::HandKind::handle);
}

} // namespace chiron::desktop
