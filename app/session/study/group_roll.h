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

/// Whether a participant is included in a condition's group value, or the reason why not.
enum class Presence : std::uint8_t {
    used,
    sealed, ///< the study is blinded, so the run's results are withheld
    notBegun,
    noAnswers,  ///< begun, but no answer counts yet
    unfinished, ///< no value: the run was broken off, and its few answers are not conclusive
    allRight,   ///< no value: every answer was right, so the threshold could be arbitrarily small
    guessing,   ///< no value: a threshold far above the presented differences is not ruled out
    unbounded,  ///< no value for another reason: the prior would decide it. A threshold far below the
                ///< presented differences is not ruled out, and often not one far above them either
    noValue,    ///< the answers give no value
    shown,      ///< left out: force was shown, not felt
    simulated,  ///< left out: the group consists of people
    withdrawn,  ///< left out
};

/// The stable name in data: "used", "not_begun".
std::string_view presenceToken(Presence presence);

/// What would help a run whose answers leave its value open.
enum class Remedy : std::uint8_t {
    none,              ///< it has a value, or this does not help
    moreTrials,        ///< there are fewer answers than a value needs
    unusedDifferences, ///< the table has differences on that side which were never presented
    otherDifferences,  ///< the table ends there: other differences are needed
    moreDifferences,   ///< one difference alone was presented, and it leaves both sides open
};

/// The remedy for a run of a condition with this table of differences (ascending). The number of answers is
/// looked at first (fewer than kFewTrials, or too few to tell them from guessing), then what the table offers
/// beyond the differences presented.
Remedy remedyFor(const psychophysics::RunEstimate& estimate, Presence presence,
                 const std::vector<double>& differences);

/// For a run whose estimate belongs to the group: whether the group's value uses it, or why not. Never
/// returns notBegun or one of the left-out values. `completed`: the run reached its end.
Presence presenceOf(const psychophysics::RunEstimate& estimate, bool completed);

struct RolledPerson {
    std::string code;
    Presence presence = Presence::notBegun; ///< of several runs, the most informative value
    bool open = false;                      ///< a run is not finished
    Remedy remedy = Remedy::none;           ///< of the run that gives `presence`
    bool guesses = false;                   ///< its answers are no better than guessing
    bool openBelow = false;                 ///< unbounded: only a threshold far below is not ruled out
    int answers = 0;                        ///< on which its estimate rests
};

/// Everybody who could be included in a condition's group value.
struct GroupRoll {
    std::vector<RolledPerson> people; ///< in the order enrolled
    bool closed = false;              ///< no further run can begin
    int planned = 0;                  ///< number of participants; 0: not stated
    int enrolled = 0;                 ///< people who did not withdraw

    int used() const;
    int expected() const; ///< participants without those left out as withdrawn or simulated
    std::vector<std::string> codesOf(Presence presence) const;
    Presence of(const std::string& code) const; ///< notBegun for a code that is not in the roll
};

/// `runs`: those of one condition, with their presence. A simulated participant is included only with a run
/// of the condition.
GroupRoll groupRoll(const std::vector<database::Participant>& participants,
                    const std::vector<AnalysedRun>& runs, bool closed, int planned = 0);

} // namespace chiron::session
