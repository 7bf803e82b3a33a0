// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/study_comparisons.h"

#include "core/random.h"
#include "psychophysics/procedures/procedure_catalogue.h"
#include "session/study/study_analysis.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace chiron::session {

namespace {

using psychophysics::RunEstimate;

/// Combines several runs: the geometric mean of the Weber fractions, with the interval of the mean of this
/// number of independent runs; their points are concatenated.
RunEstimate together(const std::vector<const RunEstimate*>& runs) {
    RunEstimate result = *runs.front();
    if (runs.size() == 1)
        return result;
    double logs = 0.0, squares = 0.0;
    for (const RunEstimate* run : runs) {
        logs += std::log10(run->weber);
        squares += std::pow(std::log10(run->weber95.high / run->weber95.low), 2);
        if (run != runs.front()) {
            result.points.insert(result.points.end(), run->points.begin(), run->points.end());
            result.warnings.insert(result.warnings.end(), run->warnings.begin(), run->warnings.end());
        }
    }
    const auto n = static_cast<double>(runs.size());
    const double half = 0.5 * std::sqrt(squares) / n;
    result.weber = std::pow(10.0, logs / n);
    result.weber95 = {result.weber * std::pow(10.0, -half), result.weber * std::pow(10.0, half)};
    return result;
}

/// Estimates by participant, for those whose values the group uses.
std::map<std::string, RunEstimate> byParticipant(const AnalysedCondition& condition) {
    std::map<std::string, std::vector<const RunEstimate*>> runs;
    for (const psychophysics::GroupMember& member : condition.group.members) {
        const AnalysedRun& run = condition.runs[static_cast<std::size_t>(member.index)];
        if (run.presence != Presence::used)
            continue;
        runs[run.participant.code].push_back(&run.estimate);
    }
    std::map<std::string, RunEstimate> people;
    for (const auto& [code, own] : runs)
        people.emplace(code, together(own));
    return people;
}

struct Pair {
    std::vector<RunEstimate> first, second; ///< those who did both, in the same order
    std::vector<RunEstimate> onlyFirst, onlySecond;
    std::vector<std::string> both, codesFirst, codesSecond; ///< their codes, in the same order
};

Pair paired(const std::map<std::string, RunEstimate>& first,
            const std::map<std::string, RunEstimate>& second) {
    Pair pair;
    for (const auto& [code, estimate] : first) {
        if (const auto other = second.find(code); other != second.end()) {
            pair.first.push_back(estimate);
            pair.second.push_back(other->second);
            pair.both.push_back(code);
        } else {
            pair.onlyFirst.push_back(estimate);
            pair.codesFirst.push_back(code);
        }
    }
    for (const auto& [code, estimate] : second)
        if (!first.contains(code)) {
            pair.onlySecond.push_back(estimate);
            pair.codesSecond.push_back(code);
        }
    return pair;
}

/// The condition's task; Magnitude, for which no thresholds are compared, if answers chose the differences.
psychophysics::Task taskOf(const StudyAnalysis& study, std::size_t condition) {
    const psychophysics::Condition* designed = study.designed(condition);
    return designed && !adapts(*designed) ? designed->task : psychophysics::Task::magnitude;
}

} // namespace

bool adapts(const psychophysics::Condition& condition) {
    return std::any_of(condition.procedures.begin(), condition.procedures.end(),
                       [](const psychophysics::ProcedureSpec& spec) {
                           return !psychophysics::kindFor(spec).trialsAreFixed();
                       });
}

bool testsThresholds(const std::vector<ComparedConditions>& compared) {
    return std::any_of(compared.begin(), compared.end(),
                       [](const ComparedConditions& each) { return std::isfinite(each.models.pValue); });
}

std::vector<ComparedConditions> compareAll(const StudyAnalysis& study, std::uint64_t seed) {
    std::vector<ComparedConditions> compared;
    if (study.blind())
        return compared;
    for (std::size_t i = 0; i < study.conditions.size(); ++i)
        for (std::size_t j = i + 1; j < study.conditions.size(); ++j) {
            const Pair pair = paired(byParticipant(study.conditions[i]), byParticipant(study.conditions[j]));
            ComparedConditions each{i, j, {}, {}};
            if (pair.first.size() >= 2) {
                each.weber = psychophysics::compareConditions(
                    pair.first, pair.second,
                    core::Random::mix(seed, "comparison " + std::to_string(i) + " " + std::to_string(j)));
                each.models = psychophysics::compareThresholdModels(taskOf(study, i), pair.first,
                                                                    taskOf(study, j), pair.second);
                each.firstPeople = each.secondPeople = pair.both;
            } else {
                each.weber = psychophysics::compareGroups(pair.onlyFirst, pair.onlySecond);
                each.firstPeople = pair.codesFirst;
                each.secondPeople = pair.codesSecond;
            }
            if (std::isfinite(each.weber.ratio))
                compared.push_back(std::move(each));
        }
    std::vector<psychophysics::ConditionComparison*> all;
    for (ComparedConditions& each : compared)
        all.push_back(&each.weber);
    psychophysics::adjustHolm(all);
    return compared;
}

} // namespace chiron::session
