// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/debrief/debrief_data.h"

#include <QLocale>
#include <QString>
#include <QStringList>
#include <string>
#include <vector>

namespace chiron::desktop {

/// Advice for a person who missed the pass mark of a metric.
struct MetricAdvice {
    std::string metric;
    QString text;
    QString moment{}; ///< sentence on its worst moment, to be filled in (catalogue::Advice::moment)
};

/// The outcome of a session in words, shown at the top of a debrief.
struct Verdict {
    const char* kind = "info"; ///< kind of the box: good, warning, bad, info
    QString icon;              ///< name of a Breeze icon
    QString title;             ///< "Passed"
    QString text;              ///< what the outcome means and what was kept
    QStringList reasons{};     ///< the pass marks that were not met, and by how much
    /// Parallel to `reasons`: the metric and what the exercise's content says of it; the texts may be empty.
    std::vector<MetricAdvice> advice{};
};

/// Describes the outcome from stored data; it decides nothing itself. `advice` comes from the exercise, in
/// the person's language. The missed pass marks follow its order, which puts causes before effects; those
/// without advice come last.
/// Thread: GUI, because it translates.
Verdict verdictOf(const DebriefHead& head, const QLocale& locale,
                  const std::vector<MetricAdvice>& advice = {});

/// "Since your last attempt: mean apex error 14.2 % → 9.10 % · ...". Covers at most three metrics with a pass
/// mark, those that failed first. `own`: the attempt is the reader's own. Empty if there was no earlier
/// attempt, or if nothing can be compared.
QString changeText(const DebriefHead& head, const QLocale& locale, bool own);

/// "12.40 % against a pass mark of ≤ 10.00 %: 2.40 % too much", for a metric that missed its pass mark.
QString missedGateText(const report::MetricRow& row, const QLocale& locale);

} // namespace chiron::desktop
