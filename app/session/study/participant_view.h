// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/study_design.h"

#include <string>
#include <vector>

namespace chiron::session {

/// A participant's view of one condition.
struct PartView {
    std::string condition; ///< id
    psychophysics::Task task = psychophysics::Task::rank3;
    psychophysics::Attribute attribute = psychophysics::Attribute::stiffness;
    int objects = 0;          ///< number of objects to explore in a trial
    int practice = 0;         ///< trials that do not count
    int trialsAtMost = 0;     ///< trials that count; 0: their number depends on the answers
    bool trialsFixed = false; ///< the number of trials is fixed
    int breaksAtMost = 0;     ///< 0 also if the number of trials is not known
    bool breaks = false;      ///< there are, or may be, breaks
    /// Expected for trialsAtMost trials, each of trial_s, with practice and breaks; 0 if the number of trials
    /// is not known. A person who explores longer takes longer, so it is no maximum.
    double minutes = 0.0;
    double trial_s = 0.0;      ///< expected for one trial (psychophysics::secondsOfTrial)
    bool rightOrWrong = false; ///< an answer in this task is right or wrong
    bool apex() const { return attribute == psychophysics::Attribute::apex; }
};

/// A participant's view of a study, derived from the values with which it is run. Every text about it for
/// people (the instructions, a summary beside the design, a checklist) is made from this, so that the texts
/// cannot contradict each other.
struct ParticipantView {
    std::vector<PartView> parts; ///< in the design's order
    double explore_s = 0.0;      ///< 0: no limit
    double answer_s = 0.0;       ///< after exploring; 0: no limit (also if exploring has none)
    int breakEvery = 0;          ///< trials between breaks; 0: no breaks
    double breakAtLeast_s = 0.0;
    /// Feedback after trials that count, in parts in which an answer is right or wrong (for an apex: its
    /// distance).
    bool feedback = false;
    bool mustTouchAll = true;
    bool probes = false; ///< with a minimum force: a light contact is not enough
    int questionsBefore = 0;
    int questionsAfter = 0;
    int questionsAfterEach = 0; ///< questions after each part

    double minutes() const; ///< expected of all parts, without questions; 0 if not known
    bool anyBreak() const;
};
/// Whether objects with this attribute are held by a ring, which is pulled or lifted and then let go.
/// Otherwise the object is pressed or stroked.
bool isTakenHold(psychophysics::Attribute attribute);
/// True if the number of trials of a condition is fixed.
bool trialsAreFixed(const psychophysics::Condition& condition);
ParticipantView participantView(const psychophysics::StudyDesign& design);

} // namespace chiron::session
