// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/score_card.h"

#include <QString>
#include <optional>
#include <string>

namespace chiron::session_report {

/// A metric's name in the program's language, or its id with spaces if it has no name. Screens, paper and the
/// command line all use these titles. `trials`: number of trials behind the value, if known (0: unknown); the
/// value of a single trial is not called a mean.
/// Thread: that of the translator (GUI), for all functions of this header.
QString metricTitle(const QString& id, int trials = 0);
/// A sentence that explains what the metric measures; empty if the metric is not known. `trials`: as above.
QString metricMeaning(const QString& id, int trials = 0);
/// What a pass mark of 100 % on the metric asks for, as a sentence without a full stop; empty if it has none.
QString metricWholly(const QString& id);
/// The name of the value at the moment to which a metric led (session::WorstMoment). At a single moment there
/// is a force or an error, but no mean and no root mean square.
QString momentTitle(const QString& id);
/// A stored unit in the program's language: "% of R" contains a word to translate, "N" does not.
QString unitText(const QString& unit);
/// The reason why a metric has no value, from the stored reason (scoring::undefinedOf). An unknown reason
/// from a later version is returned unchanged.
QString metricReason(const QString& stored);
/// The source of a benchmark band in the program's language, from the text of its metric's row.
QString bandSourceText(const QString& source);
/// The value of a metric, in its unit, that somebody reaches by guessing alone; empty if guessing has no such
/// value. `card`: the session's own values, for chance levels that depend on the trials
/// (size_error_by_chance).
std::optional<double> chanceOf(const std::string& id, const scoring::ScoreCard& card);

} // namespace chiron::session_report
