// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/study_jobs.h"

#include <QLocale>
#include <QString>
#include <QStringList>

namespace chiron::desktop {

/// The progress of a participant in one condition, and whether a run of it can be started or resumed.
struct ConditionProgress {
    /// ended: with the participant's part in the study, half-way.
    enum class State { done, interrupted, ended, notBegun };
    std::string label; ///< session::labelOf
    State state = State::notBegun;
    const LeftRun* left = nullptr; ///< for an interrupted condition; points into the row that was passed
    bool closed = false;           ///< not started, and the study accepts no more runs
    bool withdrawn = false;        ///< not started, and the participant has withdrawn
};

/// Returns the conditions in the participant's order. `row` must outlive the result.
std::vector<ConditionProgress> conditionProgress(const OpenStudy& study, const ParticipantRow& row);

/// "interrupted at trial 13 of at most 40, 28 November 2026 10:12". While the study is sealed it contains no
/// numbers, because they would reveal how many trials there were.
QString interruptedWords(const OpenStudy& study, const LeftRun& left, const QLocale& locale);

/// The state of a condition in words, beginning in lower case.
QString progressWords(const OpenStudy& study, const ConditionProgress& progress, const QLocale& locale);

/// How far a participant is with all conditions: "not begun yet", "1 of 2 done, one interrupted". Of somebody
/// who can no longer begin it says only how many are done.
QString participantProgress(const OpenStudy& study, const ParticipantRow& row, const QLocale& locale);

/// How a participant stands, in a list of people to choose from: as far as participantProgress() for somebody
/// who takes part, else the state ("Consent missing"), with the questions that are left of somebody who has
/// completed every condition.
QString participantStanding(const OpenStudy& study, const ParticipantRow& row, const QLocale& locale);

/// Returns whether something is left for this participant that can be done now: a consent, a condition or a
/// questionnaire. In a closed study no questionnaire is left for somebody who has begun nothing.
bool isWaiting(const OpenStudy& study, const ParticipantRow& row);

/// What the researcher can do next for a participant: one sentence, never empty.
QString nextStepFor(const OpenStudy& study, const ParticipantRow& row, const QString& language);

} // namespace chiron::desktop
