// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/study_design.h"

#include <string>
#include <vector>

namespace chiron::session {

/// What a participant meets in one condition.
struct PartView {
    std::string condition; ///< id
    psychophysics::Task task = psychophysics::Task::rank3;
    psychophysics::Attribute attribute = psychophysics::Attribute::stiffness;
    int objects = 0;       ///< to explore in a trial
    int practice = 0;      ///< trials that do not count
    int trialsAtMost = 0;  ///< that count; 0: the answers decide how many
    bool trialsFixed = false; ///< neither more nor fewer
    int breaksAtMost = 0;  ///< 0 also where the number of trials is not known
    bool breaks = false;   ///< there are, or may be, any
    double minutesAtMost = 0.0; ///< 0 where the number of trials is not known
    bool rightOrWrong = false;  ///< an answer of this task is right or wrong
    bool apex() const { return attribute == psychophysics::Attribute::apex; }
};

/// What a participant meets in a study, read off the values that it is run with: whatever tells people about it (the instructions, a summary
/// beside the design, a checklist) is made of this, so that none of it can say anything else.
struct ParticipantView {
    std::vector<PartView> parts; ///< in the design's order
    double explore_s = 0.0; ///< 0: no limit
    double answer_s = 0.0;  ///< after that; 0: no limit, as where exploring has none
    int breakEvery = 0;     ///< 0: none
    double breakAtLeast_s = 0.0;
    bool feedback = false;  ///< after trials that count, of parts where an answer is right or wrong (of an apex: how far from it)
    bool mustTouchAll = true;
    bool probes = false;    ///< and with a smallest force: a graze is not enough
    bool maskingSound = false;
    int questionsBefore = 0;
    int questionsAfter = 0;
    int questionsAfterEach = 0; ///< part

    double minutesAtMost() const; ///< of all parts, without questions; 0 where that is not known
    bool anyBreak() const;
};
/// Whether a condition has neither more nor fewer trials than it says.
bool trialsAreFixed(const psychophysics::Condition& condition);
ParticipantView participantView(const psychophysics::StudyDesign& design);

} // namespace chiron::session
