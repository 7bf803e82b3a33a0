// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/ready_card.h"
#include "psychophysics/study/arrangement.h"
#include "psychophysics/study/attribute.h"

namespace chiron::desktop {

/// The input device that a participant holds.
struct StudyHand {
    bool pointer = true; ///< mouse and keyboard; otherwise the handle of a haptic device
    bool felt = false;   ///< the device renders force
};

/// Whether objects with this attribute are held by a ring, which is pulled or lifted and then let go.
/// Otherwise the object is pressed or stroked.
bool isTakenHold(psychophysics::Attribute attribute);

/// How a participant explores and answers a task with the device in hand: the movements in the order in which
/// they are needed.
/// Thread: GUI.
std::vector<ControlHint> studyControls(psychophysics::Task task, psychophysics::Attribute attribute,
                                       const StudyHand& hand);
/// The remaining keys during a study session, as a line of text.
QString studyKeys(psychophysics::Task task, psychophysics::Attribute attribute, const StudyHand& hand);
/// The keys (Qt::Key) whose press counts as a first movement of the tool.
std::vector<int> studyMovementKeys(const StudyHand& hand);

} // namespace chiron::desktop
