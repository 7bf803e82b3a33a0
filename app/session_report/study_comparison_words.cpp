// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/study_comparison_words.h"

#include "session_report/study_report_text.h"
#include "session_report/study_report_words.h"

#include <cmath>

namespace chiron::session_report {

namespace {

QString pWords(double p, const QLocale& locale) {
    if (!std::isfinite(p))
        return QStringLiteral("–");
    return p < 0.001 ? QStringLiteral("< ") + locale.toString(0.001, 'f', 3) : locale.toString(p, 'f', 3);
}

} // namespace

std::vector<QString> comparisonHeadings(bool thresholds) {
    std::vector<QString> headings{Words::tr("Conditions"),    Words::tr("Ratio"),
                                  Words::tr("95 % interval"), Words::tr("p"),
                                  Words::tr("p, adjusted"),   Words::tr("Participants")};
    if (thresholds)
        headings.push_back(Words::tr("p, separate thresholds"));
    return headings;
}

std::vector<QString> comparisonRow(const session::ComparedConditions& compared, const QString& first,
                                   const QString& second, bool thresholds, const QLocale& locale) {
    const psychophysics::ConditionComparison& weber = compared.weber;
    const bool known = std::isfinite(weber.ratio95.low) && std::isfinite(weber.ratio95.high);
    std::vector<QString> cells{
        Words::tr("%1 over %2").arg(second, first),
        study_report_words::number(weber.ratio, locale),
        known ? QStringLiteral("%1 … %2").arg(study_report_words::number(weber.ratio95.low, locale),
                                              study_report_words::number(weber.ratio95.high, locale))
              : QStringLiteral("–"),
        pWords(weber.pValue, locale),
        pWords(weber.pHolm, locale),
        weber.paired ? Words::tr("%1 in both").arg(locale.toString(weber.participants))
                     : Words::tr("two groups: %1 and %2")
                           .arg(locale.toString(weber.second), locale.toString(weber.first))};
    if (thresholds)
        cells.push_back(pWords(compared.models.pValue, locale));
    return cells;
}

QString comparisonNote(bool thresholds) {
    const QString ratio = Words::tr("Ratio of the Weber fractions, 1 where both are alike; of the people who "
                                    "have a value in both conditions if there are at least two, "
                                    "otherwise of two groups, each with a value in only one of the two. "
                                    "Adjusted: for this number of comparisons (Holm).");
    if (!thresholds)
        return ratio;
    return ratio + QLatin1Char(' ') +
           Words::tr("Separate thresholds: whether one threshold for each condition describes these people's "
                     "answers better than a common one. This p is "
                     "given only where the same people answered in both and answers did not choose the "
                     "differences: after adaptive runs a fitted slope is "
                     "biased, and p would be too small.");
}

QString comparisonSealed() {
    return Words::tr("Conditions are compared once the study is unblinded: looking at the difference while "
                     "data come in would invalidate "
                     "the test.");
}

QString influenceWords(double influence, const QLocale& locale) {
    if (!std::isfinite(influence))
        return {};
    return Words::tr("The answers narrowed the prior to %1 of its width. Near 0 % the answers decide the "
                     "result; near 100 % the prior does.")
        .arg(study_report_words::percent(influence, locale));
}

QString influenceMeaning() {
    return Words::tr("How much of the result comes from the prior: near 0 % the answers decide it, near 100 "
                     "% the prior does.");
}

} // namespace chiron::session_report
