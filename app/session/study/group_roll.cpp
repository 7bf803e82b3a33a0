// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/group_roll.h"

#include "psychophysics/study/group_estimate.h"
#include "session/study/study_analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::session {

using psychophysics::hasWarning;
using psychophysics::WarningKind;

std::string_view presenceToken(Presence presence) {
    switch (presence) {
    case Presence::used:
        return "used";
    case Presence::sealed:
        return "sealed";
    case Presence::notBegun:
        return "not_begun";
    case Presence::noAnswers:
        return "no_answers";
    case Presence::unfinished:
        return "unfinished";
    case Presence::allRight:
        return "all_right";
    case Presence::guessing:
        return "guessing";
    case Presence::unbounded:
        return "unbounded";
    case Presence::noValue:
        return "no_value";
    case Presence::shown:
        return "shown";
    case Presence::simulated:
        return "simulated";
    case Presence::withdrawn:
        return "withdrawn";
    }
    return {};
}

Presence presenceOf(const psychophysics::RunEstimate& estimate, bool completed) {
    if (hasWarning(estimate.warnings, WarningKind::sealed))
        return Presence::sealed;
    const psychophysics::Usable usable = psychophysics::usableInGroup(estimate);
    if (usable == psychophysics::Usable::yes)
        return Presence::used;
    if (estimate.trials == 0)
        return Presence::noAnswers;
    if (!completed)
        return Presence::unfinished;
    if (hasWarning(estimate.warnings, WarningKind::allRight))
        return Presence::allRight;
    if (hasWarning(estimate.warnings, WarningKind::priorEdgeHigh) &&
        !hasWarning(estimate.warnings, WarningKind::priorEdgeLow))
        return Presence::guessing;
    return usable == psychophysics::Usable::priorMadeIt ? Presence::unbounded : Presence::noValue;
}

Remedy remedyFor(const psychophysics::RunEstimate& estimate, Presence presence,
                 const std::vector<double>& differences) {
    const bool open =
        presence == Presence::allRight || presence == Presence::guessing || presence == Presence::unbounded;
    if (!open)
        return Remedy::none;
    const bool low =
        presence == Presence::allRight || hasWarning(estimate.warnings, WarningKind::priorEdgeLow);
    const bool high = hasWarning(estimate.warnings, WarningKind::priorEdgeHigh);
    const auto warned = [&](WarningKind kind) { return hasWarning(estimate.warnings, kind); };
    if (warned(WarningKind::fewTrials) || warned(WarningKind::tooFewToTell))
        return Remedy::moreTrials;
    if (low == high)
        return warned(WarningKind::oneLevel) ? Remedy::moreDifferences : Remedy::moreTrials;
    if (differences.empty() || estimate.points.empty())
        return Remedy::moreTrials;
    constexpr double kSame = 1e-9; // differences are presented as they stand in the table
    const auto size = [](const psychophysics::CurvePoint& point) { return std::abs(point.difference); };
    double smallest = std::numeric_limits<double>::infinity(), largest = 0.0;
    for (const psychophysics::CurvePoint& point : estimate.points) {
        if (size(point) > 0.0)
            smallest = std::min(smallest, size(point));
        largest = std::max(largest, size(point));
    }
    const bool unused = std::any_of(differences.begin(), differences.end(), [&](double difference) {
        return difference > 0.0 && (low ? difference < smallest - kSame : difference > largest + kSame);
    });
    return unused ? Remedy::unusedDifferences : Remedy::otherDifferences;
}

int GroupRoll::used() const {
    return static_cast<int>(std::count_if(people.begin(), people.end(), [](const RolledPerson& each) {
        return each.presence == Presence::used;
    }));
}

int GroupRoll::expected() const {
    return static_cast<int>(std::count_if(people.begin(), people.end(), [](const RolledPerson& each) {
        return each.presence != Presence::withdrawn && each.presence != Presence::simulated;
    }));
}

std::vector<std::string> GroupRoll::codesOf(Presence presence) const {
    std::vector<std::string> codes;
    for (const RolledPerson& each : people)
        if (each.presence == presence)
            codes.push_back(each.code);
    return codes;
}

Presence GroupRoll::of(const std::string& code) const {
    const auto found = std::find_if(people.begin(), people.end(),
                                    [&](const RolledPerson& each) { return each.code == code; });
    return found == people.end() ? Presence::notBegun : found->presence;
}

GroupRoll groupRoll(const std::vector<database::Participant>& participants,
                    const std::vector<AnalysedRun>& runs, bool closed, int planned) {
    GroupRoll roll;
    roll.closed = closed;
    roll.planned = planned;
    for (const database::Participant& participant : participants) {
        const bool withdrawn = participant.state == database::ParticipantState::withdrawn;
        roll.enrolled += participant.simulated || withdrawn ? 0 : 1;
        RolledPerson person{participant.code, withdrawn ? Presence::withdrawn : Presence::notBegun};
        bool any = false;
        for (const AnalysedRun& run : runs) {
            if (run.participant.id != participant.id)
                continue;
            any = true;
            person.open = person.open || run.run.state == database::StudyRunState::open;
            if (person.presence == Presence::used)
                continue;
            person.presence = run.presence;
            person.remedy = run.remedy;
            person.answers = run.estimate.trials;
            person.guesses = hasWarning(run.estimate.warnings, WarningKind::chance);
            person.openBelow = run.presence == Presence::unbounded &&
                               !hasWarning(run.estimate.warnings, WarningKind::priorEdgeHigh);
        }
        if (any || !participant.simulated)
            roll.people.push_back(std::move(person));
    }
    return roll;
}

} // namespace chiron::session
