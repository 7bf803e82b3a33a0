// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/study/study_comparisons.h"

#include <QLocale>
#include <QString>
#include <vector>

namespace chiron::session_report {

/// The table of compared conditions, for screens and the printed report. `thresholds`: with the column of
/// separate thresholds (session::testsThresholds), which is omitted if it would be empty.
std::vector<QString> comparisonHeadings(bool thresholds);
/// `first`, `second`: the names of the two conditions. Returns as many cells as there are headings.
std::vector<QString> comparisonRow(const session::ComparedConditions& compared, const QString& first,
                                   const QString& second, bool thresholds, const QLocale& locale);
/// What the comparison shows, in a sentence: by how much the Weber fractions differ, or that no difference is
/// shown and what remains possible; then the statistical test, and whose values are compared, by code.
QString comparisonVerdict(const session::ComparedConditions& compared, const QString& first,
                          const QString& second, const QLocale& locale);
/// The group's Weber fraction of the condition with this name, its interval and the number of participants;
/// empty if it has none.
QString weberOfCondition(const psychophysics::GroupEstimate& group, const QString& name,
                         const QLocale& locale);
/// Returns `written`, or says that the confidence interval of a group is unbounded in practice
/// (psychophysics::isUnbounded).
QString intervalOrUnbounded(const psychophysics::Interval& interval, const QString& written);
/// The same of the interval for a further participant, which does not narrow as more take part.
QString predictionOrUnbounded(const psychophysics::Interval& prediction, const QString& written);
/// Explains the columns.
QString comparisonNote(bool thresholds);
/// The text shown while a study is blinded.
QString comparisonSealed();

/// The degree to which an estimate depends on prior assumptions (RunEstimate::priorInfluence), in words;
/// empty if it is not known.
QString influenceWords(double influence, const QLocale& locale);

/// Explains the column of these figures.
QString influenceMeaning();

} // namespace chiron::session_report
