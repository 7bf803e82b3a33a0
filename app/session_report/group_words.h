// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/run_estimate.h"
#include "session/study/group_roll.h"
#include "session/study/study_comparisons.h"

#include <QLocale>
#include <QString>
#include <QStringList>
#include <functional>
#include <vector>

namespace chiron::session_report {

/// What a condition's group value rests on: whether there is one and of how many participants; then a sentence for each reason why somebody is not in it, or
/// why it may still change, with their codes and what to do. The one statement of it, for screens, reports and the command line; no plural forms, since
/// that has no translations.
QStringList groupSentences(const session::GroupRoll& roll, const QLocale& locale);

/// By which rule a run is in its group's value and in comparisons, or is left out (psychophysics::usableInGroup). The same for all, wherever results are.
QString groupRule();

/// What is left to say of a group: the warnings that groupSentences() does not tell.
std::vector<psychophysics::Warning> furtherWarnings(const std::vector<psychophysics::Warning>& warnings);

/// Whether a run is in its group's value, for a cell: "yes", or "no: every answer was right".
QString presenceWords(session::Presence presence);

/// A value as it stands in a table: with a sign before it where its run has warnings. What is no number stays as it is.
QString markedValue(const QString& value, const psychophysics::RunEstimate& estimate);
/// What the sign means.
QString markMeaning();

/// The comparison of conditions, in words: of each two that are not compared why, or why there is no interval; of each two who is not in it and for what
/// reason; and who is left out of the whole study. Empty where everybody is in everything. `rolls`: of all conditions; `name`: what a condition is called.
QStringList comparisonSentences(const std::vector<session::GroupRoll>& rolls, const std::vector<session::ComparedConditions>& compared,
                                const std::function<QString(std::size_t)>& name, const QLocale& locale);

} // namespace chiron::session_report
