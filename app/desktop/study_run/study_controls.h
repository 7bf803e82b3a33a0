// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/ready_card.h"
#include "psychophysics/study/arrangement.h"
#include "psychophysics/study/attribute.h"
#include "simulation/comparison/comparison_parameters.h"

#include <QLocale>

namespace chiron::desktop {

/// The input device that a participant holds.
struct StudyHand {
    bool pointer = true; ///< mouse and keyboard; otherwise the handle of a haptic device
    bool felt = false;   ///< the device renders force
};

/// Where the tool lets go of what it holds.
struct LetGo {
    bool drawn = true; ///< as a dashed line at each tube (PlacesSetup::letGoHeight_m)
    /// Unit: m, below the ring (ComparisonParameters::hookLeave_m). Said where nothing is drawn.
    double below_m = simulation::ComparisonParameters{}.hookLeave_m;
};
/// How the tool lets go of a held object, as one sentence.
QString letGoSentence(psychophysics::Attribute attribute, const LetGo& letGo, const QLocale& locale);

/// How a participant explores and answers a task with the device in hand: the movements in the order in which
/// they are needed.
/// Thread: GUI.
std::vector<ControlHint> studyControls(psychophysics::Task task, psychophysics::Attribute attribute,
                                       const StudyHand& hand, const LetGo& letGo = {},
                                       const QLocale& locale = QLocale());
/// The remaining keys during a study session, as a line of text.
QString studyKeys(psychophysics::Task task, psychophysics::Attribute attribute, const StudyHand& hand);
/// The keys (Qt::Key) whose press counts as a first movement of the tool.
std::vector<int> studyMovementKeys(const StudyHand& hand);

} // namespace chiron::desktop
