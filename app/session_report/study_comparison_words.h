// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/study/study_comparisons.h"

#include <QLocale>
#include <QString>
#include <vector>

namespace chiron::session_report {

/// Conditions compared, as a table: on screens and in the printed report.
/// `thresholds`: with the column of separate thresholds (session::testsThresholds); without it where it would be empty.
std::vector<QString> comparisonHeadings(bool thresholds);
/// `first`, `second`: what the two conditions are called. As many cells as headings.
std::vector<QString> comparisonRow(const session::ComparedConditions& compared, const QString& first, const QString& second, bool thresholds, const QLocale& locale);
/// What the columns mean.
QString comparisonNote(bool thresholds);
/// While a study is blinded.
QString comparisonSealed();

/// How much an estimate rests on what was assumed beforehand (RunEstimate::priorInfluence); empty where that is not known.
QString influenceWords(double influence, const QLocale& locale);

/// What the column of these figures means.
QString influenceMeaning();

} // namespace chiron::session_report
