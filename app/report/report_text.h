// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report_data.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>

namespace chiron::report {

/// The one translation context of printed reports.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(report)
};

/// A number as people read it: 2 decimals below 100, 1 above, 3 below 1. A dash for what is not finite.
QString formatNumber(double value, const QLocale& locale);
/// The same for a value of this unit: counts are written whole.
QString formatNumber(double value, const QString& unit, const QLocale& locale);
/// Number and unit with a no-break space: "14.20 %"; a dash where there is no value.
QString formatValue(const std::optional<double>& value, const QString& unit, const QLocale& locale);
/// "≤ 25.00 %", "≥ 1.00", "1.00 – 4.00 N", "≤ 1.50 N + 10 %" where a limit lies below it; empty without a gate.
QString formatGate(const MetricRow& row, const QLocale& locale);
/// "2.90 – 25.50 %"; empty without a band.
QString formatBand(const MetricRow& row, const QLocale& locale);
/// "20 Nov 2026, 12:23 (UTC+01:00)": the local time of the recording, with its offset.
QString formatMoment(const QDateTime& utc, int offsetMinutes, const QLocale& locale);
/// "2 min 05 s"
QString formatDuration(double seconds, const QLocale& locale);
/// Words for the stored state token: "completed", "stopped by the person" ...; the token itself if unknown.
QString stateWords(const QString& token);

/// The at most three metrics to show large: those whose pass mark was not met first, then the met ones, each in the level's order.
std::vector<MetricRow> headlineRows(const std::vector<MetricRow>& metrics);

/// "by chance 50 %"; empty where guessing has no value.
QString chanceWords(const MetricRow& row, const QLocale& locale);

/// What was felt beside what the tissue answered: "The tissue answered with up to 6.20 N, of which at most 4.00 N were felt. ...".
QString feltWords(const ForceFacts& force, bool felt, const QLocale& locale);

/// That more than 1 % of the samples lay outside of the checked range, and what that means; empty where they did not.
QString beyondCheckedWords(const ForceFacts& force, const QLocale& locale);

} // namespace chiron::report
