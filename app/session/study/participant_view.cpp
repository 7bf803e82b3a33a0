// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/participant_view.h"

#include "psychophysics/planning/study_plan.h"
#include "psychophysics/procedures/procedure_catalogue.h"
#include "session/study/presentation_order.h"
#include "simulation/comparison/comparison_parameters.h"

#include <algorithm>

namespace chiron::session {

namespace {

PartView partView(const psychophysics::Condition& condition, const psychophysics::TrialRules& rules) {
    PartView part;
    part.condition = condition.id;
    part.task = condition.task;
    part.attribute = condition.stimulus.attribute;
    part.objects = part.apex() ? 1 : psychophysics::placesOf(condition.task);
    part.practice = rules.practiceTrials;
    part.trialsAtMost = trialsAtMost(condition);
    part.trialsFixed = trialsAreFixed(condition);
    part.trial_s = psychophysics::secondsOfTrial(condition, rules);
    if (part.trialsAtMost > 0) {
        part.breaksAtMost = rules.breakEvery > 0 ? (part.trialsAtMost - 1) / rules.breakEvery : 0;
        part.minutes = psychophysics::minutesOf(condition, rules, part.trialsAtMost);
    }
    part.breaks = part.breaksAtMost > 0 || (part.trialsAtMost == 0 && rules.breakEvery > 0);
    part.rightOrWrong = psychophysics::correctAnswer(condition.task, 0) >= 0;
    return part;
}

int questions(const psychophysics::StudyDesign& design, psychophysics::Questionnaire::When when) {
    int count = 0;
    for (const psychophysics::Questionnaire& each : design.questionnaires)
        count += each.when == when ? static_cast<int>(each.items.size()) : 0;
    return count;
}

} // namespace

double ParticipantView::minutes() const {
    double minutes = 0.0;
    for (const PartView& part : parts) {
        if (part.trialsAtMost == 0)
            return 0.0;
        minutes += part.minutes;
    }
    return minutes;
}

bool ParticipantView::anyBreak() const {
    return std::any_of(parts.begin(), parts.end(), [](const PartView& part) { return part.breaks; });
}

bool isTakenHold(psychophysics::Attribute attribute) {
    // Both enumerations have the same order.
    return attribute != psychophysics::Attribute::apex &&
           simulation::isHooked(static_cast<simulation::ComparedAttribute>(attribute));
}

bool trialsAreFixed(const psychophysics::Condition& condition) {
    return trialsAtMost(condition) > 0 &&
           std::all_of(condition.procedures.begin(), condition.procedures.end(),
                       [](const auto& spec) { return psychophysics::kindFor(spec).trialsAreFixed(); });
}

ParticipantView participantView(const psychophysics::StudyDesign& design) {
    const psychophysics::TrialRules& rules = design.trial;
    ParticipantView view;
    for (const psychophysics::Condition& condition : design.conditions)
        view.parts.push_back(partView(condition, rules));
    view.explore_s = rules.exploreLimit_s;
    // The clock for answering starts when the one for exploring is over.
    view.answer_s = rules.exploreLimit_s > 0.0 ? rules.answerLimit_s : 0.0;
    view.breakEvery = rules.breakEvery;
    view.breakAtLeast_s = rules.breakAtLeast_s;
    view.feedback = rules.feedback;
    view.mustTouchAll = rules.mustTouchAll;
    view.probes = rules.mustTouchAll && rules.probeAtLeast_N > 0.0;
    view.questionsBefore = questions(design, psychophysics::Questionnaire::When::before);
    view.questionsAfter = questions(design, psychophysics::Questionnaire::When::after);
    view.questionsAfterEach = questions(design, psychophysics::Questionnaire::When::afterCondition);
    return view;
}

} // namespace chiron::session
