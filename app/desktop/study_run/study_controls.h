// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/ready_card.h"
#include "psychophysics/study/arrangement.h"
#include "psychophysics/study/attribute.h"
#include "session/study/live_sitting.h"
#include "simulation/comparison/compared_object.h"
#include "simulation/comparison/comparison_parameters.h"

#include <QLocale>

namespace chiron::desktop {

/// The input device that a participant holds.
struct StudyHand {
    bool pointer = true; ///< mouse and keyboard; otherwise the handle of a haptic device
    bool felt = false;   ///< the device renders force
};

/// How a hand explores the objects of an attribute. Texts say which of these it is, since "press" is wrong
/// for somebody who lifts.
enum class Handling {
    press, ///< onto an object, and release
    stroke,
    pull, ///< a tube by its ring
    lift  ///< an object by its ring, from the table and back
};
Handling handlingOf(psychophysics::Attribute attribute);
/// Whether the tool takes hold of an object, and has to let go of it.
constexpr bool takesHold(Handling handling) {
    return handling == Handling::pull || handling == Handling::lift;
}

/// Where the tool lets go of what it holds.
struct LetGo {
    bool drawn = true; ///< as a dashed line at each tube (PlacesSetup::letGoHeight_m)
    /// Unit: m, below the ring (ComparisonParameters::hookLeave_m). Said where nothing is drawn.
    double below_m = simulation::ComparisonParameters{}.hookLeave_m;
    /// How far below the point at which a lifted object stands on the table the tool lets go of it. Unit: m
    /// (simulation::ComparedObject::kPress_N on a bed of this stiffness).
    double press_m = simulation::ComparedObject::kPress_N / simulation::ObjectAttributes{}.stiffness_N_per_m;
};
/// How the tool lets go of a held object, as one sentence.
QString letGoSentence(psychophysics::Attribute attribute, const StudyHand& hand, const LetGo& letGo,
                      const QLocale& locale);
/// How to begin with an object, from above it.
QString beginSentence(psychophysics::Attribute attribute, const StudyHand& hand);
/// What to do next with the object called `name` (empty: the only one) that is on its way from the table and
/// back; empty if none is.
QString liftSentence(session::LiveStudyView::Lift lift, const QString& name, const StudyHand& hand,
                     const LetGo& letGo, const QLocale& locale);
/// How the tool comes off before the next objects: what was held is gone by then.
QString comeOffSentence(psychophysics::Attribute attribute, const StudyHand& hand);

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
