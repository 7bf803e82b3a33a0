// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_run/study_controls.h"

#include "desktop/training/felt_words.h"

#include <QCoreApplication>
#include <cmath>

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

/// What the hand does with an object once the tool is at it, and how it comes off again.
std::vector<ControlHint> exploreHints(Attribute attribute, const StudyHand& hand, const QString& letGo) {
    const Handling handling = handlingOf(attribute);
    const QString begin = beginSentence(attribute, hand);
    const Pictogram down = hand.pointer ? Pictogram::wheelTowards : Pictogram::pressStylus;
    const Pictogram up = hand.pointer ? Pictogram::wheelAway : Pictogram::pressStylus;
    const QString raise = hand.pointer ? Words::tr("To raise the tool, roll the wheel away from you, or hold "
                                                   "Page Up.")
                                       : Words::tr("Raise the handle to come off.");
    const auto with = [&begin](const QString& next) { return begin + QLatin1Char(' ') + next; };
    switch (handling) {
    case Handling::lift:
        return {{up, Words::tr("Take hold and lift"),
                 with(hand.pointer ? Words::tr("To lift, roll the wheel away from you, or hold Page Up.")
                                   : Words::tr("To lift, raise the handle."))},
                {down, Words::tr("Put down and let go"), letGo}};
    case Handling::pull:
        return {{up, Words::tr("Take hold and pull"),
                 with(hand.pointer ? Words::tr("To pull, roll the wheel away from you, or hold Page Up.")
                                   : Words::tr("To pull, raise the handle."))},
                {down, Words::tr("Let go"), letGo}};
    case Handling::stroke:
        return {{down, Words::tr("Press lightly and stroke"),
                 with(hand.pointer ? Words::tr("Then move the mouse, or use the arrow keys.")
                                   : Words::tr("Then move it to and fro.")) +
                     QLatin1Char(' ') + raise}};
    case Handling::press:
        break;
    }
    return {{down, Words::tr("Press"), with(raise)}};
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

Handling handlingOf(Attribute attribute) {
    switch (attribute) {
    case Attribute::mass:
        return Handling::lift;
    case Attribute::stiffness:
        return Handling::pull;
    case Attribute::roughness:
    case Attribute::friction:
    case Attribute::viscosity:
        return Handling::stroke;
    case Attribute::deformation:
    case Attribute::apex:
        break;
    }
    return Handling::press;
}

QString beginSentence(Attribute attribute, const StudyHand& hand) {
    if (takesHold(handlingOf(attribute)))
        return hand.pointer ? Words::tr("Move the tool over a ring and lower it into the ring: roll the "
                                        "wheel towards you, or hold Page Down.")
                            : Words::tr("Move the tip over a ring and lower it into the ring.");
    return hand.pointer ? Words::tr("Move the tool over an object and lower it onto the object: roll the "
                                    "wheel towards you, or hold Page Down.")
                        : Words::tr("Move the tip over an object and push it gently into the object.");
}

namespace {

/// To a tenth, and never less than it takes.
QString millimetres(double metres, const QLocale& locale) {
    constexpr double kTenths = 1e4, kRounding = 1e-6;
    return locale.toString(std::ceil(metres * kTenths - kRounding) / 10.0, 'g', 3);
}

/// With how much force an object is pressed onto the table before the tool lets go of it.
QString pressNewtons(const QLocale& locale) {
    return locale.toString(simulation::ComparedObject::kPress_N, 'g', 2);
}

} // namespace

QString comeOffSentence(Attribute attribute, const StudyHand& hand) {
    if (!takesHold(handlingOf(attribute)))
        return Words::tr("Lift the tool off.");
    return hand.pointer ? Words::tr("Raise the tool.") : Words::tr("Raise the handle.");
}

QString letGoSentence(Attribute attribute, const StudyHand& hand, const LetGo& letGo, const QLocale& locale) {
    if (attribute == Attribute::mass)
        return hand.pointer
                   ? Words::tr("To put the object down, roll the wheel towards you, or hold Page Down, until "
                               "the object stands on the table, and at least %1 mm further. Then raise the "
                               "tool: the object stays there.")
                         .arg(millimetres(letGo.press_m, locale))
                   : Words::tr("To put the object down, lower it onto the table and press it down with at "
                               "least %1 N. Then raise the handle: the object stays there.")
                         .arg(pressNewtons(locale));
    if (!letGo.drawn)
        return Words::tr("To let go, lower the tool %1 mm below the ring, then raise it.")
            .arg(millimetres(letGo.below_m, locale));
    return hand.pointer ? Words::tr("To let go, lower the tool below the dashed line (roll the wheel towards "
                                    "you, or hold Page Down), then raise it.")
                        : Words::tr("To let go, lower the tip below the dashed line, then raise it.");
}

namespace {

QString heldWords(const QString& name, const StudyHand& hand) {
    const QString lift = hand.pointer
                             ? Words::tr("Lift it off the table: roll the wheel away from you, or hold "
                                         "Page Up.")
                             : Words::tr("Lift it off the table.");
    return (name.isEmpty() ? Words::tr("You are holding the object.")
                           : Words::tr("You are holding object %1.").arg(name)) +
           QLatin1Char(' ') + lift;
}

QString raisedWords(const QString& name, const StudyHand& hand) {
    const QString down = hand.pointer ? Words::tr("To put it down, lower it to the table: roll the wheel "
                                                  "towards you, or hold Page Down.")
                                      : Words::tr("To put it down, lower it to the table.");
    return (name.isEmpty() ? Words::tr("You are lifting the object.")
                           : Words::tr("You are lifting object %1.").arg(name)) +
           QLatin1Char(' ') + down;
}

QString standsWords(const QString& name, const StudyHand& hand, const LetGo& letGo, const QLocale& locale) {
    const QString press =
        hand.pointer ? Words::tr("To let go, lower the tool at least %1 mm further, then raise it.")
                           .arg(millimetres(letGo.press_m, locale))
                     : Words::tr("To let go, press it onto the table with at least %1 N, then raise the "
                                 "handle.")
                           .arg(pressNewtons(locale));
    return (name.isEmpty() ? Words::tr("The object stands on the table, and you still hold it.")
                           : Words::tr("Object %1 stands on the table, and you still hold it.").arg(name)) +
           QLatin1Char(' ') + press;
}

} // namespace

QString liftSentence(session::LiveStudyView::Lift lift, const QString& name, const StudyHand& hand,
                     const LetGo& letGo, const QLocale& locale) {
    using Lift = session::LiveStudyView::Lift;
    switch (lift) {
    case Lift::held:
        return heldWords(name, hand);
    case Lift::raised:
        return raisedWords(name, hand);
    case Lift::stands:
        return standsWords(name, hand, letGo, locale);
    case Lift::pressed:
        return name.isEmpty() ? Words::tr("Now raise the tool: the object stays on the table.")
                              : Words::tr("Now raise the tool: object %1 stays on the table.").arg(name);
    case Lift::none:
        break;
    }
    return {};
}

std::vector<ControlHint> studyControls(Task task, Attribute attribute, const StudyHand& hand,
                                       const LetGo& letGo, const QLocale& locale) {
    const bool click = attribute == Attribute::apex;
    const Pictogram answer = hand.pointer ? (click ? Pictogram::leftClick : Pictogram::keys)
                             : click      ? Pictogram::stylusButton
                                          : Pictogram::keys;
    std::vector<ControlHint> hints{moveHint(hand)};
    for (ControlHint& hint : exploreHints(attribute, hand, letGoSentence(attribute, hand, letGo, locale)))
        hints.push_back(std::move(hint));
    hints.push_back({answer, Words::tr("Answer"), answerHow(task, attribute, hand)});
    return hints;
}

QString studyKeys(Task, Attribute, const StudyHand& hand) {
    const QString always = felt_words::stopKeys(hand.felt);
    return hand.pointer
               ? Words::tr("Without a wheel, hold the right mouse button or Shift and move the mouse "
                           "forward to raise the tool, back to lower it. %1 T frees the pointer, so "
                           "that the answers can be clicked as well; a click in the scene takes it "
                           "back and does not count as an answer.")
                     .arg(always)
               : Words::tr("%1 The answers can be clicked as well.").arg(always);
}

std::vector<int> studyMovementKeys(const StudyHand& hand) {
    return movementKeys(session::PointerTool::point,
                        hand.pointer ? devices::HandKind::mouseAndKeyboard : devices::HandKind::handle);
}

} // namespace chiron::desktop
