// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/questionnaire_replies.h"

#include "psychophysics/measures/sample_moments.h"

#include <cmath>

namespace chiron::session {

namespace {

/// What is compared between people in one condition; less is better. Not a number where a run gives none, or was shown and not felt.
double errorOf(const AnalysedRun& run) {
    if (!run.felt.value_or(true))
        return std::nan("");
    return run.apex ? run.apex->meanAbsolutePercent : std::log10(run.estimate.weber);
}

} // namespace

std::map<database::ParticipantNumber, double> performanceOf(const StudyAnalysis& analysis) {
    std::map<database::ParticipantNumber, std::vector<double>> standings;
    for (const AnalysedCondition& condition : analysis.conditions) {
        std::vector<double> errors;
        for (const AnalysedRun& run : condition.runs)
            if (std::isfinite(errorOf(run)))
                errors.push_back(errorOf(run));
        const psychophysics::SampleMoments moments = psychophysics::momentsOf(errors);
        if (!(moments.sd > 0.0))
            continue;
        for (const AnalysedRun& run : condition.runs)
            if (std::isfinite(errorOf(run)))
                standings[run.participant.id].push_back((moments.mean - errorOf(run)) / moments.sd);
    }
    std::map<database::ParticipantNumber, double> performance;
    for (const auto& [participant, values] : standings)
        performance[participant] = psychophysics::momentsOf(values).mean;
    return performance;
}

std::vector<psychophysics::QuestionnaireReply> questionnaireReplies(const psychophysics::Questionnaire& questionnaire,
                                                                    const std::vector<database::QuestionnaireAnswer>& answers,
                                                                    const std::map<database::ParticipantNumber, double>& performance) {
    std::map<database::ParticipantNumber, psychophysics::QuestionnaireReply> replies;
    for (const database::QuestionnaireAnswer& answer : answers) {
        if (answer.questionnaire != questionnaire.id || (!answer.number && answer.text.empty()))
            continue;
        psychophysics::QuestionnaireReply& reply = replies[answer.participant];
        if (answer.number)
            reply.numbers[answer.item] = *answer.number;
        else
            reply.texts[answer.item] = answer.text;
        if (const auto found = performance.find(answer.participant); found != performance.end())
            reply.performance = found->second;
    }
    std::vector<psychophysics::QuestionnaireReply> list;
    for (auto& [participant, reply] : replies)
        list.push_back(std::move(reply));
    return list;
}

} // namespace chiron::session
