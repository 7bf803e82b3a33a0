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

/// What each participant answered to one questionnaire, by participant, beside how well they did (where `performance` says so). Erased
/// answers are none.
std::vector<psychophysics::QuestionnaireReply> questionnaireReplies(const psychophysics::Questionnaire& questionnaire,
                                                                    const std::vector<database::QuestionnaireAnswer>& answers,
                                                                    const std::map<database::ParticipantNumber, double>& performance);

} // namespace chiron::session
