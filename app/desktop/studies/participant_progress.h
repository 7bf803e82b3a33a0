// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/study_store.h"

#include <QLocale>
#include <QString>
#include <QStringList>

namespace chiron::desktop {

/// Of one condition of a participant: what became of it, and whether a run of it can be begun or resumed.
struct ConditionProgress {
    enum class State { done, interrupted, ended, notBegun }; ///< ended: with the participant's part in the study, half-way
    std::string label; ///< session::labelOf
    State state = State::notBegun;
    const LeftRun* left = nullptr; ///< of an interrupted one; in the row that was asked about
    bool closed = false;           ///< not begun, and the study takes no run any more
};

/// By condition, in the participant's order. `row` has to outlive it.
std::vector<ConditionProgress> conditionProgress(const OpenStudy& study, const ParticipantRow& row);

/// "interrupted at trial 13 of at most 40, 28 November 2026 10:12"; while the study is sealed without numbers, which would tell how many there were.
QString interruptedWords(const OpenStudy& study, const LeftRun& left, const QLocale& locale);

/// What became of a condition, in words; begins in lower case.
QString progressWords(const OpenStudy& study, const ConditionProgress& progress, const QLocale& locale);

/// What the researcher can do for a participant now: a sentence, never empty.
QString nextStepFor(const OpenStudy& study, const ParticipantRow& row, const QString& language);

} // namespace chiron::desktop
