// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_types.h"
#include "psychophysics/study/run_estimate.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::session {

struct AnalysedRun;

/// Whether somebody is in a condition's group value, or why not.
enum class Presence : std::uint8_t {
    used,
    sealed,     ///< the study is blinded, and nothing is said of the run
    notBegun,
    noAnswers,  ///< begun, and no answer counts yet
    unfinished, ///< no value, and the run was broken off: its few answers say nothing of the participant yet
    allRight,   ///< no value: the threshold is below what was presented
    guessing,   ///< no value: the answers, as guesses would, leave open how large the threshold is
    unbounded,  ///< no value for another reason: the prior made it
    noValue,    ///< the answers give none
    shown,      ///< left out: objects were shown, not felt
    simulated,  ///< left out: the group is of people
    withdrawn,  ///< left out
};

/// What it is called in data: "used", "not_begun". Stable.
std::string_view presenceToken(Presence presence);

/// Of a run whose estimate belongs to the group: whether the group's value uses it, or why not. Never notBegun, nor left out. `completed`: the run
/// came to its end.
Presence presenceOf(const psychophysics::RunEstimate& estimate, bool completed);

struct RolledPerson {
    std::string code;
    Presence presence = Presence::notBegun; ///< of several runs that which says most
    bool open = false; ///< a run is not finished
};

/// Everybody who could be in a condition's group value.
struct GroupRoll {
    std::vector<RolledPerson> people; ///< in the order enrolled
    bool closed = false;              ///< no run can be begun any more
    int planned = 0;                  ///< participants; 0: not said
    int enrolled = 0;                 ///< people who did not withdraw

    int used() const;
    int expected() const; ///< who take part: without those who are left out because they withdrew or were simulated
    std::vector<std::string> codesOf(Presence presence) const;
    Presence of(const std::string& code) const; ///< notBegun for whoever is not on it
};

/// `runs`: of one condition, with their presence. Simulated participants are on it only with a run of the condition.
GroupRoll groupRoll(const std::vector<database::Participant>& participants, const std::vector<AnalysedRun>& runs, bool closed, int planned = 0);

} // namespace chiron::session
