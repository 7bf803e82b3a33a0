// SPDX-License-Identifier: GPL-3.0-or-later
// The results of each condition: group, persons, curves.
#include "session_report/group_words.h"
#include "session_report/marked_estimates.h"
#include "session_report/run_curve_plot.h"
#include "session_report/study_comparison_words.h"
#include "session_report/study_report_blocks.h"
#include "session_report/study_report_text.h"
#include "session_report/study_report_words.h"
#include "session_report/study_warning_words.h"

#include <algorithm>
#include <cmath>
#include <qcustomplot.h>

namespace chiron::session_report {

namespace words = study_report_words;
using report::PlotStyle;
using report::PlotView;

namespace {

constexpr double kPercent = 100.0;
constexpr double kWeberPlotHeight = 200.0;
constexpr double kCurveHeight = 300.0; // its legend has up to six lines
constexpr std::size_t kCurvesInRow = 2;

std::unique_ptr<PlotView> curvePlot(const session::AnalysedRun& run, bool ranks,
                                    const report::PlotTheme& theme) {
    auto plot = std::make_unique<PlotView>(theme);
    plot->setTitle(QString::fromStdString(run.participant.code));
    drawRunCurve(*plot, run.estimate, ranks);
    return plot;
}

} // namespace

void StudyReportBlocks::addCondition(std::size_t at) {
    const session::AnalysedCondition& condition = m_data.analysis.conditions[at];
    addHeading(m_data.conditionName(at));
    if (condition.runs.empty() && m_data.blind())
        return addMuted(Words::tr("Nobody has done this condition yet."));
    if (condition.runs.empty()) {
        for (const QString& said : groupSentences(condition.roll, m_theme.locale))
            addMuted(said);
        return;
    }
    if (m_data.analysis.sealed())
        return addMuted(Words::tr(
            "The result, the time and the number of trials stay sealed until the study is unblinded."));
    if (condition.apex)
        return addApex(at);
    addGroup(at);
    addWeberPlot(condition);
    addRuns(at);
    addRankings(condition);
    if (!m_data.blind()) // their differences would reveal the conditions
        addCurves(at);
}

void StudyReportBlocks::addGroup(std::size_t at) {
    const psychophysics::GroupEstimate& group = m_data.analysis.conditions[at].group;
    const psychophysics::Attribute attribute = m_data.attribute(at);
    const QLocale& locale = m_theme.locale;
    std::vector<std::pair<QString, QString>> pairs;
    if (std::isfinite(group.weber)) {
        pairs = {{Words::tr("Weber fraction of the group"), words::percent(group.weber, locale)},
                 {Words::tr("95 % interval"),
                  intervalOrUnbounded(group.weber95,
                                      words::intervalPercent(group.weber95.low, group.weber95.high, locale))},
                 {Words::tr("95 % prediction interval"),
                  predictionOrUnbounded(
                      group.prediction95,
                      words::intervalPercent(group.prediction95.low, group.prediction95.high, locale))}};
        if (!m_data.blind())
            pairs.emplace_back(Words::tr("JND at the reference"), words::value(group.jnd, attribute, locale));
    }
    if (!m_data.blind() && std::isfinite(group.pse))
        pairs.emplace_back(Words::tr("Point of subjective equality"),
                           words::value(group.pse, attribute, locale));
    if (std::isfinite(group.exponent))
        pairs.emplace_back(Words::tr("Exponent of the power law"), words::number(group.exponent, locale));
    if (!pairs.empty())
        addPairs(pairs, 3);
    for (const QString& said : groupSentences(m_data.analysis.conditions[at].roll, locale))
        addMuted(said);
    if (m_data.analysis.conditions.size() < 2) // otherwise the comparison states it
        addMuted(groupRule());
    for (const psychophysics::Warning& warning : furtherWarnings(group.warnings))
        addMuted(QStringLiteral("! ") + warningWords(warning));
}

void StudyReportBlocks::addWeberPlot(const session::AnalysedCondition& condition) {
    std::vector<QString> names;
    MarkedEstimates estimates;
    for (const session::AnalysedRun& run : condition.runs) {
        const double place = static_cast<double>(names.size());
        names.push_back(markedValue(QString::fromStdString(run.participant.code), run.estimate));
        estimates.add(place, run.estimate, run.presence);
    }
    if (estimates.empty())
        return;
    auto plot = std::make_unique<PlotView>(m_theme);
    plot->setYAxis({Words::tr("Weber fraction (%)"), 0.0, {}});
    estimates.draw(*plot);
    if (std::isfinite(condition.group.weber))
        plot->addReference(Words::tr("group"), kPercent * condition.group.weber);
    plot->setXCategories(names);
    std::vector<std::unique_ptr<PlotView>> row;
    row.push_back(std::move(plot));
    addPlotRow(std::move(row), kWeberPlotHeight);
}

void StudyReportBlocks::addRuns(std::size_t at) {
    const session::AnalysedCondition& condition = m_data.analysis.conditions[at];
    const psychophysics::Attribute attribute = m_data.attribute(at);
    const QLocale& locale = m_theme.locale;
    std::vector<std::vector<QString>> rows;
    for (const session::AnalysedRun& run : condition.runs) {
        const psychophysics::RunEstimate& estimate = run.estimate;
        QStringList remarks{Words::tr("In the group value: %1.").arg(presenceWords(run.presence))};
        for (const psychophysics::Warning& warning : estimate.warnings)
            remarks << QStringLiteral("! ") + warningWords(warning);
        const bool open = run.run.state == database::StudyRunState::open;
        rows.push_back(
            {QString::fromStdString(run.participant.code),
             supportedValue(words::percent(estimate.weber, locale), estimate, open),
             supportedInterval(words::intervalPercent(estimate.weber95.low, estimate.weber95.high, locale),
                               estimate),
             // The mark on the Weber fraction applies to the whole row.
             m_data.blind() ? QStringLiteral("–")
                            : supportedInterval(words::value(estimate.jnd, attribute, locale), estimate),
             std::isfinite(estimate.priorInfluence) ? words::percent(estimate.priorInfluence, locale)
                                                    : QStringLiteral("–"),
             run.spoiled > 0 ? Words::tr("%1 (%2 repeated)")
                                   .arg(locale.toString(run.scored), locale.toString(run.spoiled))
                             : locale.toString(run.scored),
             words::runState(run.run.state), remarks.join(QLatin1Char(' '))});
    }
    addTable({Words::tr("Code"), Words::tr("Weber fraction"), Words::tr("95 % interval"), Words::tr("JND"),
              Words::tr("Prior influence"), Words::tr("Scored"), Words::tr("Run"),
              Words::tr("In the group, and warnings")},
             rows, {0.1, 0.1, 0.135, 0.11, 0.1, 0.075, 0.125, 0.255},
             {false, true, true, true, true, true, false, false});
    if (std::any_of(condition.runs.begin(), condition.runs.end(),
                    [](const session::AnalysedRun& run) { return !run.estimate.warnings.empty(); }))
        addMuted(markMeaning());
    const auto known = [](const session::AnalysedRun& run) {
        return std::isfinite(run.estimate.priorInfluence);
    };
    if (std::any_of(condition.runs.begin(), condition.runs.end(), known))
        addMuted(Words::tr("Share of the prior: %1").arg(influenceMeaning()));
}

void StudyReportBlocks::addComparisons() {
    const session::StudyAnalysis& analysis = m_data.analysis;
    if (analysis.conditions.size() < 2)
        return;
    addHeading(Words::tr("Conditions compared"));
    if (m_data.blind())
        return addMuted(comparisonSealed());
    addMuted(groupRule());
    for (std::size_t i = 0; i < analysis.conditions.size(); ++i)
        if (const QString words =
                weberOfCondition(analysis.conditions[i].group, m_data.conditionName(i), m_theme.locale);
            !words.isEmpty())
            addText(words, m_theme.font(13), m_theme.ink, 5);
    const bool thresholds = session::testsThresholds(analysis.comparisons);
    std::vector<std::vector<QString>> rows;
    for (const session::ComparedConditions& each : analysis.comparisons) {
        const QString first = m_data.conditionName(each.first), second = m_data.conditionName(each.second);
        addText(comparisonVerdict(each, first, second, m_theme.locale), m_theme.font(13), m_theme.ink, 5);
        rows.push_back(comparisonRow(each, first, second, thresholds, m_theme.locale));
    }
    if (!rows.empty()) {
        if (thresholds)
            addTable(comparisonHeadings(thresholds), rows, {0.27, 0.09, 0.17, 0.09, 0.1, 0.17, 0.11},
                     {false, true, true, true, true, true, true});
        else
            addTable(comparisonHeadings(thresholds), rows, {0.31, 0.1, 0.19, 0.1, 0.11, 0.19},
                     {false, true, true, true, true, true});
        addMuted(comparisonNote(thresholds));
    }
    if (std::any_of(analysis.conditions.begin(), analysis.conditions.end(),
                    [](const auto& each) { return each.apex.has_value(); }))
        return; // Weber fractions cannot be compared for marks
    std::vector<session::GroupRoll> rolls;
    for (const session::AnalysedCondition& condition : analysis.conditions)
        rolls.push_back(condition.roll);
    for (const QString& said : comparisonSentences(
             rolls, analysis.comparisons, [this](std::size_t at) { return m_data.conditionName(at); },
             m_theme.locale))
        addMuted(said);
}

void StudyReportBlocks::addCurves(std::size_t at) {
    const session::AnalysedCondition& condition = m_data.analysis.conditions[at];
    const psychophysics::Condition* designed = m_data.analysis.designed(at);
    const bool ranks = designed && psychophysics::ranksThree(designed->task);
    std::vector<std::unique_ptr<PlotView>> row;
    for (const session::AnalysedRun& run : condition.runs) {
        if (run.estimate.curveDifference.empty() && run.estimate.points.empty())
            continue;
        row.push_back(curvePlot(run, ranks, m_theme));
        if (row.size() < kCurvesInRow)
            continue;
        addPlotRow(std::move(row), kCurveHeight);
        row.clear();
    }
    addPlotRow(std::move(row), kCurveHeight);
}

} // namespace chiron::session_report
