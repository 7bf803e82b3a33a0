// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/study_device.h"
#include "psychophysics/study/study_design.h"

#include <QString>

namespace chiron::desktop {

/// The sentences of a study's instructions that follow from its settings: task, number of answers and trials,
/// practice, time, feedback, breaks, questionnaires. They are generated from session::ParticipantView.
/// Whether a noise is heard depends on the station: sittingSentences() says it on the participant's page.
/// `language` is the language of the texts, independent of the program's.
QStringList participantSentences(const psychophysics::StudyDesign& design, const QString& language);

/// The sentence that names the force and the speed from which on a trial of this condition is repeated
/// (session::FidelityMeter). It is no part of the frozen instructions: participants read it before each part.
QString limitSentence(const psychophysics::StudyDesign& design, const psychophysics::Condition& condition,
                      const QString& language);
/// The same of all conditions of a design, each sentence once.
QStringList limitSentences(const psychophysics::StudyDesign& design, const QString& language);
/// What the device can do, and the limits of the study (limitSentences, the same as in the instructions), for
/// somebody who is asked to consent.
QStringList forceSentences(const psychophysics::StudyDesign& design, const StudyDevice& device,
                           const QString& language);

/// The researcher's own sentences in the instructions; the entire instructions if none have been generated
/// from the settings yet.
const psychophysics::StudyText& ownSentences(const psychophysics::StudyDesign& design);

/// The instructions as participants read them. Earlier versions generated a sentence about the masking noise,
/// which is now said where it is true (sittingSentences()); a frozen text still contains it.
psychophysics::StudyText shownInstructions(const psychophysics::StudyDesign& design);

/// Assembles the instructions from the researcher's own sentences and those generated from the settings, so
/// that they cannot contradict the study. It does so in each language that the researcher wrote in, or in all
/// three if nothing was written.
void renewInstructions(psychophysics::StudyDesign& design);

} // namespace chiron::desktop
