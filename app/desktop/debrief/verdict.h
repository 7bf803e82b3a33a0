// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/debrief/debrief_data.h"

#include <QLocale>
#include <QString>
#include <QStringList>

namespace chiron::desktop {

/// How a session came out, in words: the sentence at the top of a debrief.
struct Verdict {
    const char* kind = "info"; ///< of the box: good, warning, bad, info
    QString icon;              ///< Breeze name
    QString title;             ///< "Passed"
    QString text;              ///< what it means and what was kept
    QStringList reasons;       ///< which pass marks were not met, and by how much
};

/// GUI thread (words). Reads what was stored; decides nothing.
Verdict verdictOf(const DebriefHead& head, const QLocale& locale);

/// "12.40 % against a pass mark of ≤ 10.00 %: 2.40 % too much", for a metric whose gate did not hold.
QString missedGateText(const report::MetricRow& row, const QLocale& locale);

} // namespace chiron::desktop
