// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/report_text.h"

#include "scoring/score_card.h"

#include <QTimeZone>
#include <algorithm>
#include <cmath>
#include <iterator>

namespace chiron::report {

namespace {
const QString kDash = QStringLiteral("–");
const QString kNoBreak = QStringLiteral("\u00a0");

/// Counts are whole numbers and need no unit: the name of the row states what is counted.
bool isCount(const QString& unit) {
    return unit == QLatin1String("count");
}

QString withUnit(const QString& number, const QString& unit) {
    return unit.isEmpty() || isCount(unit) ? number : number + kNoBreak + unit;
}
} // namespace

QString formatNumber(double value, const QLocale& locale) {
    if (!std::isfinite(value))
        return kDash;
    const double size = std::abs(value);
    if (size >= 1e7 || (size > 0.0 && size < 1e-5))
        return locale.toString(value, 'e', 2);
    if (size > 0.0 && size < 0.1) { // two significant figures, without an exponent: "0.00046 mm"
        int decimals = 1 - static_cast<int>(std::floor(std::log10(size)));
        if (std::round(size * std::pow(10.0, decimals)) >= 100.0) // rounded up to the next power of ten
            --decimals;
        return locale.toString(value, 'f', decimals);
    }
    // Three significant figures.
    const int decimals = size >= 100.0 ? 0 : size >= 10.0 ? 1 : size >= 1.0 || size == 0.0 ? 2 : 3;
    return locale.toString(value, 'f', decimals);
}

QString formatNumber(double value, const QString& unit, const QLocale& locale) {
    const bool whole = isCount(unit) && std::isfinite(value) && value == std::round(value);
    return whole ? locale.toString(value, 'f', 0) : formatNumber(value, locale);
}

QString formatValue(const std::optional<double>& value, const QString& unit, const QLocale& locale) {
    return value && std::isfinite(*value) ? withUnit(formatNumber(*value, unit, locale), unit) : kDash;
}

QString formatGate(const MetricRow& row, const QLocale& locale) {
    if (row.gateMinimum && row.gateMaximum)
        return withUnit(formatNumber(*row.gateMinimum, row.unit, locale) + QStringLiteral(" – ") +
                            formatNumber(*row.gateMaximum, row.unit, locale),
                        row.unit);
    if (row.gateMaximum == 0.0 && isCount(row.unit))
        return QStringLiteral("0"); // a count cannot be below zero
    // The limit is shown as the same number everywhere.
    if (row.gateMaximum && row.limit && *row.limit > 0.0)
        return QStringLiteral("%1 + %2").arg(
            withUnit(QStringLiteral("≤ ") + formatNumber(*row.limit, row.unit, locale), row.unit),
            withUnit(locale.toString(qRound(100.0 * (*row.gateMaximum / *row.limit - 1.0))),
                     QStringLiteral("%")));
    if (row.gateMaximum)
        return withUnit(QStringLiteral("≤ ") + formatNumber(*row.gateMaximum, row.unit, locale), row.unit);
    if (row.gateMinimum && scoring::asksForAll(*row.gateMinimum, row.unit.toStdString()))
        return withUnit(formatNumber(*row.gateMinimum, row.unit, locale), row.unit);
    if (row.gateMinimum)
        return withUnit(QStringLiteral("≥ ") + formatNumber(*row.gateMinimum, row.unit, locale), row.unit);
    return {};
}

QString formatBand(const MetricRow& row, const QLocale& locale) {
    if (!row.bandLow || !row.bandHigh)
        return {};
    return withUnit(formatNumber(*row.bandLow, locale) + QStringLiteral(" – ") +
                        formatNumber(*row.bandHigh, locale),
                    row.unit);
}

QString formatMoment(const QDateTime& utc, int offsetMinutes, const QLocale& locale) {
    if (!utc.isValid())
        return kDash;
    const QDateTime local = utc.toUTC().toOffsetFromUtc(offsetMinutes * 60);
    const int minutes = std::abs(offsetMinutes);
    const QString offset = QStringLiteral("UTC%1%2:%3")
                               .arg(offsetMinutes < 0 ? QStringLiteral("−") : QStringLiteral("+"))
                               .arg(minutes / 60, 2, 10, QLatin1Char('0'))
                               .arg(minutes % 60, 2, 10, QLatin1Char('0'));
    return QStringLiteral("%1, %2 (%3)")
        .arg(locale.toString(local.date(), QStringLiteral("d MMM yyyy")),
             locale.toString(local.time(), QStringLiteral("HH:mm")), offset);
}

QString formatDuration(double seconds, const QLocale& locale) {
    if (!std::isfinite(seconds) || seconds < 0.0)
        return kDash;
    const double whole = std::round(seconds);
    if (seconds < 60.0)
        return locale.toString(seconds, 'f', 1) + kNoBreak + QStringLiteral("s");
    return QStringLiteral("%1%3min %2%3s")
        .arg(static_cast<qint64>(whole) / 60)
        .arg(static_cast<qint64>(whole) % 60, 2, 10, QLatin1Char('0'))
        .arg(kNoBreak);
}

QString stateWords(const QString& token) {
    if (token == QLatin1String("completed"))
        return Words::tr("completed");
    if (token == QLatin1String("stopped"))
        return Words::tr("stopped by the person");
    if (token == QLatin1String("interrupted"))
        return Words::tr("interrupted: the program ended during the session");
    if (token == QLatin1String("incomplete"))
        return Words::tr("incomplete: samples were lost");
    if (token == QLatin1String("faulted"))
        return Words::tr("faulted: the device or supervisor stopped it");
    if (token == QLatin1String("voided"))
        return Words::tr("voided by a trainer");
    return token;
}

std::vector<MetricRow> headlineRows(const std::vector<MetricRow>& metrics) {
    constexpr std::size_t kMost = 3;
    std::vector<MetricRow> chosen;
    std::copy_if(metrics.begin(), metrics.end(), std::back_inserter(chosen),
                 [](const MetricRow& row) { return row.headline; });
    std::stable_partition(chosen.begin(), chosen.end(),
                          [](const MetricRow& row) { return row.passed == std::optional<bool>(false); });
    if (chosen.size() > kMost)
        chosen.resize(kMost);
    return chosen;
}

QString chanceWords(const MetricRow& row, const QLocale& locale) {
    return row.chance ? Words::tr("by chance %1").arg(formatValue(row.chance, row.unit, locale)) : QString();
}

QString feltWords(const ForceFacts& force, bool felt, const QLocale& locale) {
    const auto newtons = [&locale](double value) { return formatValue(value, QStringLiteral("N"), locale); };
    constexpr double kContact_N = 0.02; // models.md §6
    if (force.tissue_N < kContact_N)
        return Words::tr("Nothing was touched.");
    if (!felt)
        return Words::tr("The tissue force reached %1. None of it was felt: the force was only shown.")
            .arg(newtons(force.tissue_N));
    if (!force.firstLimited_s)
        return Words::tr("The tissue force reached %1, and all of it was felt.").arg(newtons(force.tissue_N));
    return Words::tr("The tissue force reached %1, but at most %2 of it was felt: the force was limited for "
                     "%3, first after %4.")
        .arg(newtons(force.tissue_N), newtons(force.felt_N),
             formatValue(force.limited_s, QStringLiteral("s"), locale),
             formatDuration(*force.firstLimited_s, locale));
}

QString beyondCheckedWords(const ForceFacts& force, const QLocale& locale) {
    if (!(force.beyondChecked > kBeyondCheckedSaid))
        return {};
    return Words::tr("%1 of the samples lie deeper or farther out than the range in which the force law was "
                     "checked. Their force is "
                     "bounded and counts, but it is less certain than the rest.")
        .arg(formatValue(100.0 * force.beyondChecked, QStringLiteral("%"), locale));
}

} // namespace chiron::report
