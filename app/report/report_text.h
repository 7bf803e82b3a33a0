// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/report_data.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>

namespace chiron::report {

/// The single translation context of printed reports.
struct Words {
    Q_DECLARE_TR_FUNCTIONS(report)
};

/// A number in display form, with three significant figures: no decimals from 100, 1 from 10, 2 from 1, 3
/// from 0.1. Smaller numbers have two significant figures ("0.00046"); scientific notation is used from 1e7
/// and below 1e-5. A dash if the value is not finite.
QString formatNumber(double value, const QLocale& locale);
/// The same for a value with this unit; counts are written as whole numbers.
QString formatNumber(double value, const QString& unit, const QLocale& locale);
/// Number and unit with a no-break space: "14.20 %"; a dash if there is no value.
QString formatValue(const std::optional<double>& value, const QString& unit, const QLocale& locale);
/// "≤ 25.00 %", "≥ 1.00", "1.00 – 4.00 N", or "≤ 1.50 N + 10 %" if the level's limit is below the pass mark;
/// empty without a pass mark.
QString formatGate(const MetricRow& row, const QLocale& locale);
/// "2.90 – 25.50 %"; empty without a band.
QString formatBand(const MetricRow& row, const QLocale& locale);
/// "20 Nov 2026, 12:23 (UTC+01:00)": the local time of the recording, with its offset.
QString formatMoment(const QDateTime& utc, int offsetMinutes, const QLocale& locale);
/// "2 min 05 s"
QString formatDuration(double seconds, const QLocale& locale);
/// The words for the stored state token: "completed", "stopped by the person" and so on; the token itself if
/// it is unknown.
QString stateWords(const QString& token);

/// At most three metrics to show large: first those that missed their pass mark, then those that met it, each
/// in the level's order.
std::vector<MetricRow> headlineRows(const std::vector<MetricRow>& metrics);

/// "by chance 50 %"; empty if guessing has no such value.
QString chanceWords(const MetricRow& row, const QLocale& locale);

/// Compares the felt force with the tissue's force: "The tissue answered with up to 6.20 N, of which at most
/// 4.00 N were felt. ...".
QString feltWords(const ForceFacts& force, bool felt, const QLocale& locale);

/// States that more than 1 % of the samples lay outside the checked range, and what that means; empty if this
/// is not the case.
QString beyondCheckedWords(const ForceFacts& force, const QLocale& locale);

} // namespace chiron::report
