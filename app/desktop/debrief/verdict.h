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
    QStringList reasons{};     ///< which pass marks were not met, and by how much
    QStringList advice{};      ///< of each reason: what to do differently, as the exercise's content says; may be empty
};

/// What to do differently where a metric's pass mark was missed.
struct MetricAdvice {
    std::string metric;
    QString text;
};

/// GUI thread (words). Reads what was stored; decides nothing. `advice`: of the exercise, in the person's language; the missed pass
/// marks are told in its order, which puts a cause before what it leads to, and after them those without advice.
Verdict verdictOf(const DebriefHead& head, const QLocale& locale, const std::vector<MetricAdvice>& advice = {});

/// "Since your last attempt: mean apex error 14.2 % → 9.10 % · ...": of the metrics with a pass mark, at most three, those that failed
/// first. `own`: the reader's attempt. Empty where there was no attempt before, or nothing of it can be compared.
QString changeText(const DebriefHead& head, const QLocale& locale, bool own);

/// "12.40 % against a pass mark of ≤ 10.00 %: 2.40 % too much", for a metric whose gate did not hold.
QString missedGateText(const report::MetricRow& row, const QLocale& locale);

} // namespace chiron::desktop
