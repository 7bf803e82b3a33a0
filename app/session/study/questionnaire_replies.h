// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/measures/questionnaire_measures.h"
#include "session/study/study_analysis.h"

#include <map>
#include <vector>

namespace chiron::session {

/// The performance of each participant over the conditions: the mean, in standard deviations of the
/// condition, of how far their Weber fraction (log10; for an apex: mean error) is below that of the others;
/// larger is better. Contains only participants with such a run.
std::map<database::ParticipantNumber, double> performanceOf(const StudyAnalysis& analysis);

/// The condition that an answer is about: its id, or its sealed code while blinded; empty if the
/// questionnaire is asked once.
std::string labelOf(const database::QuestionnaireAnswer& answer);

/// Answers to one questionnaire that belong together: at most one per question and participant.
struct AnsweredPart {
    std::string label; ///< label of the condition that they are about; empty if the questionnaire is asked
                       ///< once
    std::vector<database::QuestionnaireAnswer> answers;
};
/// Splits the answers into parts. A questionnaire that is asked once has one part with all answers, even if
/// nobody has answered. One that is asked after each condition has a part for each condition with an answer,
/// in the design's order, followed by sealed codes in their order. Withheld answers are omitted.
std::vector<AnsweredPart> answeredParts(const psychophysics::StudyDesign& design,
                                        const psychophysics::Questionnaire& questionnaire,
                                        const std::vector<database::QuestionnaireAnswer>& answers);

/// The answers of each participant to one questionnaire (of one part, if it is asked after each condition),
/// ordered by participant, with the participant's performance (if `performance` contains it). Erased answers
/// are omitted.
std::vector<psychophysics::QuestionnaireReply>
questionnaireReplies(const psychophysics::Questionnaire& questionnaire,
                     const std::vector<database::QuestionnaireAnswer>& answers,
                     const std::map<database::ParticipantNumber, double>& performance);

} // namespace chiron::session
