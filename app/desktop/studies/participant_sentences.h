// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/study_design.h"

#include <QString>

namespace chiron::desktop {

/// What participants are told of a study that follows from its settings: what to do, number of answers and trials, practice, time, feedback,
/// breaks, questions. A sentence each, made of session::ParticipantView. `language`: of the texts, whatever the program speaks.
QStringList participantSentences(const psychophysics::StudyDesign& design, const QString& language);

/// The researcher's own sentences of the instructions: all of them, where none are made from the settings yet.
const psychophysics::StudyText& ownSentences(const psychophysics::StudyDesign& design);

/// Makes the instructions of the researcher's own sentences and those of the settings, so that neither can say what the study does not do. In
/// each language that the researcher wrote in; in all three where nothing was written.
void renewInstructions(psychophysics::StudyDesign& design);

} // namespace chiron::desktop
