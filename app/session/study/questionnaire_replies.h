// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/measures/questionnaire_summary.h"
#include "session/study/study_analysis.h"

#include <map>
#include <vector>

namespace chiron::session {

/// How well each participant did, over the conditions: the mean of how far below the others' Weber fraction (log10; of an apex: mean
/// error) theirs is, in standard deviations of its condition; more is better. Who has no such run is not in it.
std::map<database::ParticipantNumber, double> performanceOf(const StudyAnalysis& analysis);

/// What an answer is about: the condition's id, or its sealed code while blinded; empty where the questionnaire is asked once.
std::string labelOf(const database::QuestionnaireAnswer& answer);

/// Answers to one questionnaire that belong together: at most one to a question of each participant.
struct AnsweredPart {
    std::string label; ///< of the condition that they are about; empty where the questionnaire is asked once
    std::vector<database::QuestionnaireAnswer> answers;
};
/// One part with all of them where the questionnaire is asked once, also where nobody has answered; where it is asked after each condition one for
/// each that somebody has answered about, in the design's order, sealed codes behind it by code. What is withheld is in none.
std::vector<AnsweredPart> answeredParts(const psychophysics::StudyDesign& design, const psychophysics::Questionnaire& questionnaire,
                                        const std::vector<database::QuestionnaireAnswer>& answers);

/// What each participant answered to one questionnaire (of a part, where it is asked after each condition), by participant, beside how well they did (where `performance` says so). Erased
/// answers are none.
std::vector<psychophysics::QuestionnaireReply> questionnaireReplies(const psychophysics::Questionnaire& questionnaire,
                                                                    const std::vector<database::QuestionnaireAnswer>& answers,
                                                                    const std::map<database::ParticipantNumber, double>& performance);

} // namespace chiron::session
