// SPDX-License-Identifier: GPL-3.0-or-later
// The results of ranking three objects, for the persons of a condition and for its group.
#include "session_report/study_report_blocks.h"
#include "session_report/study_report_text.h"
#include "session_report/study_report_words.h"

#include <algorithm>
#include <cmath>
#include <qcustomplot.h>

namespace chiron::session_report {

namespace words = study_report_words;
using psychophysics::RankingSummary;
using psychophysics::WorthEstimate;
using report::PlotView;

namespace {

constexpr double k95 = 1.959963984540054; // 97.5 % quantile of the normal distribution
constexpr double kRankingPlotHeight = 190.0;

QString fixed(double value, const QLocale& locale) {
    return std::isfinite(value) ? locale.toString(value, 'f', 2) : QStringLiteral("–");
}

QString fixedInterval(double low, double high, const QLocale& locale) {
    return std::isfinite(low) && std::isfinite(high)
               ? QStringLiteral("%1 … %2").arg(fixed(low, locale), fixed(high, locale))
               : QStringLiteral("–");
}

QString withP(const QString& value, double p, const QLocale& locale) {
    if (!std::isfinite(p))
        return value;
    return p < 0.001 ? Words::tr("%1 (p < %2)").arg(value, locale.toString(0.001, 'f', 3))
                     : Words::tr("%1 (p = %2)").arg(value, locale.toString(p, 'f', 3));
}

std::vector<QString> rankingRow(const QString& who, const RankingSummary& summary, const QLocale& locale) {
    const double p =
        std::isfinite(summary.agreement.exactP) ? summary.agreement.exactP : summary.agreement.pValue;
    return {who,
            QStringLiteral("%1 / %2").arg(locale.toString(summary.complete.right),
                                          locale.toString(summary.complete.of)),
            words::intervalPercent(summary.complete.low, summary.complete.high, locale),
            fixed(summary.tau, locale),
            fixedInterval(summary.tauLow, summary.tauHigh, locale),
            withP(fixed(summary.agreement.w, locale), p, locale),
            withP(words::number(summary.trend.l, locale), summary.trend.pValue, locale)};
}

std::unique_ptr<PlotView> worthPlot(const QString& title, const QString& axis, const WorthEstimate& worth,
                                    const report::PlotTheme& theme) {
    auto plot = std::make_unique<PlotView>(theme);
    plot->setTitle(title);
    plot->setYAxis({axis, {}, {}});
    plot->setLegendShown(false);
    plot->setXCategories({Words::tr("reference"), Words::tr("D more"), Words::tr("2D more")});
    std::vector<report::PlotPoint> points;
    std::vector<double> halves;
    for (std::size_t i = 0; worth.fitted && i < worth.logWorth.size(); ++i) {
        points.push_back({static_cast<double>(i), worth.logWorth[i]});
        halves.push_back(i < worth.standardError.size() ? k95 * worth.standardError[i]
                                                        : std::numeric_limits<double>::quiet_NaN());
    }
    if (points.empty())
        plot->setNote(Words::tr("Not estimable"));
    else
        plot->addMeans(Words::tr("estimate with its 95 % interval"), points, halves);
    return plot;
}

} // namespace

void StudyReportBlocks::addRankings(const session::AnalysedCondition& condition) {
    const QLocale& locale = m_theme.locale;
    const RankingSummary& group = condition.ranking;
    std::vector<std::vector<QString>> rows;
    for (const session::AnalysedRun& run : condition.runs)
        if (run.ranking.rankings > 0)
            rows.push_back(rankingRow(QString::fromStdString(run.participant.code), run.ranking, locale));
    if (rows.empty())
        return;
    if (group.rankings > 0)
        rows.push_back(rankingRow(Words::tr("Group"), group, locale));
    addTable({Words::tr("Rankings"), Words::tr("Right"), Words::tr("95 % interval"), Words::tr("Kendall's τ"),
              Words::tr("95 % interval"), Words::tr("Kendall's W"), Words::tr("Page's L")},
             rows, {0.13, 0.09, 0.17, 0.1, 0.15, 0.18, 0.18}, {false, true, true, true, true, true, true});
    addMuted(Words::tr(
        "Right: rankings with the whole order right (guessing gives 1 in 6, fewer with ties). τ: agreement "
        "with the true "
        "order (1 identical, 0 none). W: agreement among rankings (0 none, 1 complete). L: trend towards the "
        "true order. "
        "For a person, each ranking is one judgement; for the group, each person's mean ranks are one."));
    if (std::any_of(condition.runs.begin(), condition.runs.end(),
                    [](const session::AnalysedRun& run) { return run.ranking.adaptive; }))
        addMuted(Words::tr("Each answer decided what came next, so one person's trials are not independent: "
                           "they have no interval and no p."));
    if (std::isfinite(group.wLow))
        addMuted(Words::tr("95 % interval for W of the group, from its participants: %1")
                     .arg(fixedInterval(group.wLow, group.wHigh, locale)));
    if (!group.plackettLuce.fitted && !group.thurstone.fitted)
        return addMuted(Words::tr(
            "The worths cannot be estimated: one object was always, or never, ranked above the others."));
    std::vector<std::unique_ptr<PlotView>> row;
    row.push_back(
        worthPlot(group.tied > 0 ? Words::tr("Bradley-Terry, ties by Davidson") : Words::tr("Bradley-Terry"),
                  Words::tr("ln worth"), group.bradleyTerry, m_theme));
    row.push_back(worthPlot(Words::tr("Plackett-Luce"), Words::tr("ln worth"), group.plackettLuce, m_theme));
    row.push_back(worthPlot(Words::tr("Thurstone"), Words::tr("Scale (SD)"), group.thurstone, m_theme));
    addPlotRow(std::move(row), kRankingPlotHeight);
    addMuted(Words::tr(
        "Worth of each object, from all rankings of the group: how much more often it was ranked above the "
        "others. The "
        "farther apart two objects are, the easier they are to tell apart. All differences D are pooled."));
}

} // namespace chiron::session_report
