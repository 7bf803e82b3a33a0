// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/elastic_tube/report/tube_report.h"

#include "report/block_maker.h"
#include "report/plot_view.h"
#include "report/report_text.h"

#include <algorithm>
#include <cmath>

namespace chiron::report {

namespace {

bool anyNumber(const std::vector<double>& values) {
    return std::any_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

std::unique_ptr<PlotView> overTime(const QString& title, const QString& quantity, const TubeReport& tube,
                                   const PlotTheme& theme) {
    auto view = std::make_unique<PlotView>(theme);
    view->setTitle(title);
    PlotAxis time{Words::tr("Time (s)"), std::nullopt, std::nullopt};
    if (tube.t_s.size() > 1) {
        time.minimum = tube.t_s.front();
        time.maximum = tube.t_s.back();
    }
    view->setXAxis(time);
    view->setYAxis({quantity, 0.0, {}});
    return view;
}

void finishTube(PlotView& view, const TubeReport& tube) {
    std::vector<TimeSpan> paused;
    for (const TubeReport::Span& span : tube.paused)
        paused.push_back({span.begin_s, span.end_s});
    view.addHatchedSpans(Words::tr("paused"), paused);
    std::vector<TimedEvent> trials;
    for (std::size_t i = 0; i < tube.trialStart_s.size() && i < tube.rows.size(); ++i)
        trials.push_back({tube.trialStart_s[i], QString::number(tube.rows[i].trial + 1)});
    view.addEvents(trials);
    if (tube.t_s.empty())
        view.setNote(Words::tr("No trial was started"));
}

QString inUnit(const std::optional<double>& value, const char* unit, const QLocale& locale) {
    return formatValue(value, QLatin1String(unit), locale);
}

QString count(const std::optional<double>& value, const QLocale& locale) {
    return formatValue(value, QStringLiteral("count"), locale);
}

} // namespace

std::unique_ptr<PlotView> tensionPlot(const TubeReport& tube, const PlotTheme& theme) {
    auto view = overTime(Words::tr("Tension of the tube"), Words::tr("Tension (N)"), tube, theme);
    if (anyNumber(tube.bandLow_N)) {
        view->addLine(Words::tr("band, from"), tube.t_s, tube.bandLow_N, PlotStyle::dashedB);
        view->addLine(Words::tr("band, to"), tube.t_s, tube.bandHigh_N, PlotStyle::dashedB);
    }
    view->addLine(Words::tr("tension"), tube.t_s, tube.tension_N, PlotStyle::solidA);
    finishTube(*view, tube);
    return view;
}

std::unique_ptr<PlotView> retractionPlot(const TubeReport& tube, const PlotTheme& theme) {
    if (!(tube.retractionHigh_N > 0.0))
        return nullptr;
    auto view = overTime(Words::tr("Pull on the fold of tissue"), Words::tr("Pull (N)"), tube, theme);
    const std::vector<double> low(tube.t_s.size(), tube.retractionLow_N),
        high(tube.t_s.size(), tube.retractionHigh_N);
    view->addLine(Words::tr("band, from"), tube.t_s, low, PlotStyle::dashedB);
    view->addLine(Words::tr("band, to"), tube.t_s, high, PlotStyle::dashedB);
    view->addLine(Words::tr("pull"), tube.t_s, tube.retraction_N, PlotStyle::solidA);
    finishTube(*view, tube);
    return view;
}

std::unique_ptr<PlotView> stretchPlot(const TubeReport& tube, const PlotTheme& theme) {
    auto view = overTime(Words::tr("How far the tube was stretched"), Words::tr("Stretch (mm)"), tube, theme);
    if (anyNumber(tube.markLow_mm)) {
        view->addLine(Words::tr("mark, from"), tube.t_s, tube.markLow_mm, PlotStyle::dashedB);
        view->addLine(Words::tr("mark, to"), tube.t_s, tube.markHigh_mm, PlotStyle::dashedB);
    }
    if (tube.overStretch_mm > 0.0) {
        view->shadeAbove(Words::tr("over-stretched"), tube.t_s, tube.stretch_mm, tube.overStretch_mm);
        view->addLimit(
            Words::tr("limit %1").arg(formatValue(tube.overStretch_mm, QStringLiteral("mm"), theme.locale)),
            tube.overStretch_mm);
    }
    view->addLine(Words::tr("stretch"), tube.t_s, tube.stretch_mm, PlotStyle::solidA);
    finishTube(*view, tube);
    return view;
}

WordTable tubeTable(const TubeReport& tube, const QLocale& locale) {
    WordTable table{{Words::tr("Trial"), Words::tr("Outcome"), Words::tr("Target"),
                     Words::tr("Tension error"), Words::tr("In the band"), Words::tr("Largest stretch"),
                     Words::tr("Over-stretches"), Words::tr("Drops")},
                    {}};
    const bool fold = tube.retractionHigh_N > 0.0;
    if (fold)
        table.head.push_back(Words::tr("Retraction in the band"));
    for (const TubeTrialRow& row : tube.rows) {
        table.rows.push_back({locale.toString(row.trial + 1), trialOutcomeWords(row.outcome, true),
                              inUnit(row.target_N, "N", locale), inUnit(row.error_N, "N", locale),
                              inUnit(row.inBand_s, "s", locale), inUnit(row.stretchMax_mm, "mm", locale),
                              count(row.overStretches, locale), count(row.drops, locale)});
        if (fold)
            table.rows.back().push_back(inUnit(row.retractionInBand_percent, "%", locale));
    }
    return table;
}

void TubeSection::addTo(BlockMaker& blocks) const {
    blocks.addHeading(Words::tr("Tension and stretch"));
    for (auto plot : {tensionPlot, retractionPlot, stretchPlot})
        blocks.addPlot(plot(m_tube, blocks.theme()), 216);
    blocks.addTrialTable(tubeTable(m_tube, blocks.theme().locale));
}

} // namespace chiron::report
