// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/score_card.h"

#include <QString>
#include <optional>
#include <string>

namespace chiron::session_report {

/// A metric's name in the program's language; its id with spaces where it has no name of its own. The one source of titles for
/// screens, paper and the command line. Thread of the translator (GUI), as all of these.
/// `trials`: how many the value is of, where that is known (0: it is not); the value of a single one is no mean.
QString metricTitle(const QString& id, int trials = 0);
/// What it measures, in a sentence for people; empty for one that is not known. `trials`: as above.
QString metricMeaning(const QString& id, int trials = 0);
/// What the value at one moment is called that a metric led to (session::WorstMoment): at a moment there is a force or an error, and neither
/// their mean nor their root mean square.
QString momentTitle(const QString& id);
/// A stored unit in the program's language: "% of R" has a word in it, "N" has none.
QString unitText(const QString& unit);
/// Why a metric has no value, from the stored reason (scoring::undefinedOf); a reason that is none of ours, of a later version, as it is.
QString metricReason(const QString& stored);
/// Where a benchmark band is from.
QString bandSourceText(const QString& source);
/// What somebody who only guesses reaches in a metric, in its unit; nothing where guessing has no such value. `card`: the
/// session's own values, for chance that depends on what was there (size_error_by_chance).
std::optional<double> chanceOf(const std::string& id, const scoring::ScoreCard& card);

} // namespace chiron::session_report
