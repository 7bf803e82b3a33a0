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

/// Explains a condition's group value: whether there is one and how many participants it includes, followed
/// by a sentence for each reason why somebody is not included or why the value may still change, with their
/// number, their codes and the action to take. Screens, reports and the command line all use this text. It
/// avoids plural forms, because the command line has no translations.
QStringList groupSentences(const session::GroupRoll& roll, const QLocale& locale);

/// The rule by which a run is included in its group's value and in comparisons, or left out
/// (psychophysics::usableInGroup). The same text everywhere results are shown.
QString groupRule();

/// The warnings about a group that groupSentences() does not cover.
std::vector<psychophysics::Warning> furtherWarnings(const std::vector<psychophysics::Warning>& warnings);

/// Whether a run is included in its group's value, for a table cell: "yes", or "no: every answer was right".
QString presenceWords(session::Presence presence);

/// A value of a run, or its interval, for tables and pages: as written (with the sign of markedValue), or
/// that the run has none because its answers do not support it (psychophysics::usableInGroup). `open`:
/// answers may still be added.
QString supportedValue(const QString& value, const psychophysics::RunEstimate& estimate, bool open);
QString supportedInterval(const QString& interval, const psychophysics::RunEstimate& estimate);
/// Why the answers of a run support no value, in a few words; empty if they support one.
QString whyNoValue(const psychophysics::RunEstimate& estimate);

/// A value for a table, preceded by a sign if its run has warnings. NaN is unchanged.
QString markedValue(const QString& value, const psychophysics::RunEstimate& estimate);
/// Explains the sign.
QString markMeaning();

/// Explains the comparison of conditions: for each pair that is not compared, the reason; for each pair
/// without an interval, the reason; for each pair, the participants who are not included and why; and the
/// participants left out of the whole study. Empty if everybody is included everywhere. `rolls`: those of all
/// conditions; `name`: the name of a condition.
QStringList comparisonSentences(const std::vector<session::GroupRoll>& rolls,
                                const std::vector<session::ComparedConditions>& compared,
                                const std::function<QString(std::size_t)>& name, const QLocale& locale);

} // namespace chiron::session_report
