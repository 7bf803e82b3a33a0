// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/ready_card.h"
#include "psychophysics/study/arrangement.h"
#include "psychophysics/study/attribute.h"

namespace chiron::desktop {

/// What is in a participant's hand.
struct StudyHand {
    bool pointer = true; ///< mouse and keyboard; else a haptic device's handle
    bool felt = false;   ///< the device renders force
};

/// How a participant explores and answers a task with what they hold: the movements in the order in which they are needed. GUI thread.
/// A ring is taken hold of, pulled or lifted, and let go; else the object is pressed or stroked.
bool isTakenHold(psychophysics::Attribute attribute);

std::vector<ControlHint> studyControls(psychophysics::Task task, psychophysics::Attribute attribute, const StudyHand& hand);
/// The keys of a sitting beside those, as a line of text.
QString studyKeys(psychophysics::Task task, psychophysics::Attribute attribute, const StudyHand& hand);
/// The keys (Qt::Key) of the tool whose press counts as a first movement.
std::vector<int> studyMovementKeys(const StudyHand& hand);

} // namespace chiron::desktop
