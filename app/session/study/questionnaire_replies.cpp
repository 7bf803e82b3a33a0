// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/questionnaire_replies.h"

#include "psychophysics/measures/sample_moments.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace chiron::session {

namespace {

/// The value that is compared between people in one condition; smaller is better. NaN if a run has none, or
/// was shown and not felt.
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

std::string labelOf(const database::QuestionnaireAnswer& answer) {
    return answer.condition.empty() ? answer.sealedCode : answer.condition;
}

std::vector<AnsweredPart> answeredParts(const psychophysics::StudyDesign& design,
                                        const psychophysics::Questionnaire& questionnaire,
                                        const std::vector<database::QuestionnaireAnswer>& answers) {
    std::vector<AnsweredPart> parts;
    if (questionnaire.when != psychophysics::Questionnaire::When::afterCondition)
        parts.emplace_back();
    for (const database::QuestionnaireAnswer& answer : answers) {
        if (answer.questionnaire != questionnaire.id || answer.withheld)
            continue;
        auto part = std::find_if(parts.begin(), parts.end(),
                                 [&](const AnsweredPart& each) { return each.label == labelOf(answer); });
        if (part == parts.end())
            part = parts.insert(parts.end(), {labelOf(answer), {}});
        part->answers.push_back(answer);
    }
    const auto place = [&](const AnsweredPart& part) {
        const auto& all = design.conditions;
        return std::find_if(all.begin(), all.end(),
                            [&](const psychophysics::Condition& each) { return each.id == part.label; }) -
               all.begin();
    };
    std::sort(parts.begin(), parts.end(), [&](const AnsweredPart& a, const AnsweredPart& b) {
        return std::pair(place(a), a.label) < std::pair(place(b), b.label);
    });
    return parts;
}

std::vector<psychophysics::QuestionnaireReply>
questionnaireReplies(const psychophysics::Questionnaire& questionnaire,
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
