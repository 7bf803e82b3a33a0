// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace chiron::desktop {

/// A metric's name in the language of the screen; its id with spaces where it has no name of its own. GUI thread, as all of
/// these.
QString metricTitle(const QString& id);
/// What it measures, in a sentence for people; empty for one that is not known.
QString metricMeaning(const QString& id);
/// A stored unit in the language of the screen: "% of R" has a word in it, "N" has none.
QString unitText(const QString& unit);
/// Why a metric has no value, from the stored reason.
QString metricReason(const QString& reason);
/// Where a benchmark band is from.
QString bandSourceText(const QString& source);

} // namespace chiron::desktop
