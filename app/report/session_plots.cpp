// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/session_plots.h"

#include "report/report_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace chiron::report {

namespace {

std::unique_ptr<PlotView> timePlot(const QString& title, const PlotAxis& yAxis, const SampleSeries& series,
                                   const PlotTheme& theme) {
    auto view = std::make_unique<PlotView>(theme);
    view->setTitle(title);
    PlotAxis time{Words::tr("Time (s)"), std::nullopt, std::nullopt};
    if (series.t_s.size() > 1) { // exactly the whole session
        time.minimum = series.t_s.front();
        time.maximum = series.t_s.back();
    }
    view->setXAxis(time);
    view->setYAxis(yAxis);
    return view;
}

void finish(PlotView& view, const SampleSeries& series, bool empty) {
    view.addHatchedSpans(Words::tr("paused"), series.paused);
    view.addEvents(series.events);
    if (empty)
        view.setNote(Words::tr("No samples were recorded"));
}

/// The line style of a tool in every plot of several tools.
PlotStyle styleOf(std::size_t tool) {
    // The dash-dotted style is reserved for a second session.
    constexpr std::array kStyles{PlotStyle::solidA, PlotStyle::dashedB, PlotStyle::dottedC,
                                 PlotStyle::longDashE};
    return kStyles[std::min(tool, kStyles.size() - 1)];
}

using Quantity = std::vector<double> ToolSamples::*;

const std::vector<double>& firstOf(const SampleSeries& series, Quantity quantity) {
    static const std::vector<double> kNone;
    return series.tools.empty() ? kNone : series.tools.front().*quantity;
}

/// Adds one line per tool, named after the tool if there are several, else `alone`.
void addTools(PlotView& view, const SampleSeries& series, Quantity quantity, const QString& alone) {
    if (series.tools.empty()) // nothing was recorded: add the name to the legend
        view.addLine(alone, series.t_s, {}, styleOf(0));
    for (std::size_t tool = 0; tool < series.tools.size(); ++tool)
        if (const std::vector<double>& values = series.tools[tool].*quantity; !values.empty())
            view.addLine(series.tools.size() > 1 ? series.tools[tool].name : alone, series.t_s, values,
                         styleOf(tool));
}

std::size_t toolOf(const CriticalError& error) {
    return static_cast<std::size_t>(std::max(error.tool, 0));
}

/// The sample with the largest force on the error's tool during the error; empty if the tool has no samples.
std::optional<std::size_t> worstOf(const SampleSeries& series, const CriticalError& error) {
    const std::size_t tool = toolOf(error);
    if (series.t_s.empty() || tool >= series.tools.size() ||
        series.tools[tool].tissue_N.size() != series.t_s.size())
        return std::nullopt;
    const auto first = std::lower_bound(series.t_s.begin(), series.t_s.end(), error.begin_s);
    const auto end = std::upper_bound(first, series.t_s.end(), error.end_s);
    const auto from = std::min(first - series.t_s.begin(), std::ssize(series.t_s) - 1);
    const auto to = std::max(end - series.t_s.begin(), from + 1);
    const auto force = series.tools[tool].tissue_N.begin();
    return static_cast<std::size_t>(std::max_element(force + from, force + to) - force);
}

/// Adds crosses on the tools' lines of `quantity`, at the worst sample of each error. `legend`: also adds the
/// name and the errors' numbers.
void markCriticalErrors(PlotView& view, const SampleSeries& series, Quantity quantity, bool legend = true) {
    std::vector<PlotPoint> points;
    std::vector<int> numbers;
    for (std::size_t i = 0; i < series.criticalErrors.size(); ++i) {
        const auto worst = worstOf(series, series.criticalErrors[i]);
        if (!worst)
            continue;
        const std::vector<double>& values = series.tools[toolOf(series.criticalErrors[i])].*quantity;
        if (*worst >= values.size())
            continue;
        points.push_back({series.t_s[*worst], values[*worst]});
        numbers.push_back(static_cast<int>(i) + 1);
    }
    if (points.empty())
        return;
    view.addMarkers(legend ? Words::tr("critical error") : QString(), points, PlotStyle::solidA, true);
    if (legend)
        view.addCounts(points, numbers);
}

void addLimitLine(PlotView& view, double limit_N, const PlotTheme& theme) {
    view.addLimit(Words::tr("limit %1").arg(formatValue(limit_N, QStringLiteral("N"), theme.locale)),
                  limit_N);
}

std::unique_ptr<PlotView> toolsForcePlot(const QString& title, const SampleSeries& series, Quantity quantity,
                                         double limit_N, const PlotTheme& theme) {
    const bool any = std::any_of(series.tools.begin(), series.tools.end(),
                                 [&](const ToolSamples& tool) { return !(tool.*quantity).empty(); });
    if (series.tools.size() < 2 || !any)
        return nullptr;
    auto view = timePlot(title, {Words::tr("Force (N)"), 0.0, {}}, series, theme);
    addTools(*view, series, quantity, {});
    addLimitLine(*view, limit_N, theme);
    markCriticalErrors(*view, series, quantity);
    finish(*view, series, false);
    return view;
}

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

// Sample standard deviation (n - 1); NaN for fewer than two values, because it does not exist.
double deviation(const std::vector<double>& values, double centre) {
    if (values.size() < 2)
        return std::numeric_limits<double>::quiet_NaN();
    double squares = 0.0;
    for (const double value : values)
        squares += (value - centre) * (value - centre);
    return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

} // namespace

std::vector<std::unique_ptr<PlotView>> positionPlots(const SampleSeries& series, const PlotTheme& theme) {
    std::vector<std::unique_ptr<PlotView>> plots;
    const bool empty = series.t_s.empty() || firstOf(series, &ToolSamples::x_mm).empty();
    if (series.tools.size() > 1) {
        for (const auto& [title, quantity] :
             {std::pair{Words::tr("Position of the tool tips, x"), &ToolSamples::x_mm},
              std::pair{Words::tr("Position of the tool tips, y"), &ToolSamples::y_mm},
              std::pair{Words::tr("Position of the tool tips, z"), &ToolSamples::z_mm}}) {
            plots.push_back(timePlot(title, {Words::tr("Position (mm)"), {}, {}}, series, theme));
            addTools(*plots.back(), series, quantity, {});
            markCriticalErrors(*plots.back(), series, quantity);
            finish(*plots.back(), series, empty);
        }
        return plots;
    }
    plots.push_back(
        timePlot(Words::tr("Position of the tool tip"), {Words::tr("Position (mm)"), {}, {}}, series, theme));
    PlotView& view = *plots.back();
    view.addLine(QStringLiteral("x"), series.t_s, firstOf(series, &ToolSamples::x_mm), PlotStyle::solidA);
    view.addLine(QStringLiteral("y"), series.t_s, firstOf(series, &ToolSamples::y_mm), PlotStyle::dashedB);
    view.addLine(QStringLiteral("z"), series.t_s, firstOf(series, &ToolSamples::z_mm), PlotStyle::dottedC);
    for (const Quantity quantity : {&ToolSamples::x_mm, &ToolSamples::y_mm, &ToolSamples::z_mm})
        markCriticalErrors(view, series, quantity, quantity == &ToolSamples::z_mm);
    finish(view, series, empty);
    return plots;
}

std::unique_ptr<PlotView> forcePlot(const SampleSeries& series, double limit_N, const PlotTheme& theme) {
    const bool several = series.tools.size() > 1;
    auto view = timePlot(several ? Words::tr("Force of the tissue on each tool (assessed)")
                                 : Words::tr("Force on the tool"),
                         {Words::tr("Force (N)"), 0.0, {}}, series, theme);
    QString over = Words::tr("over the limit");
    for (const ToolSamples& tool : series.tools)
        if (view->shadeAbove(over, series.t_s, tool.tissue_N, limit_N))
            over.clear(); // only once in the legend
    // The assessed force is drawn last, on top.
    if (!several && !firstOf(series, &ToolSamples::measured_N).empty())
        view->addLine(Words::tr("measured"), series.t_s, firstOf(series, &ToolSamples::measured_N),
                      PlotStyle::dottedC);
    if (!several && !firstOf(series, &ToolSamples::commanded_N).empty())
        view->addLine(Words::tr("felt (commanded)"), series.t_s, firstOf(series, &ToolSamples::commanded_N),
                      PlotStyle::dashedB);
    addTools(*view, series, &ToolSamples::tissue_N, Words::tr("tissue (assessed)"));
    addLimitLine(*view, limit_N, theme);
    markCriticalErrors(*view, series, &ToolSamples::tissue_N);
    finish(*view, series, series.t_s.empty() || firstOf(series, &ToolSamples::tissue_N).empty());
    return view;
}

std::unique_ptr<PlotView> feltForcePlot(const SampleSeries& series, double limit_N, const PlotTheme& theme) {
    return toolsForcePlot(Words::tr("Force felt (commanded) on each tool"), series, &ToolSamples::commanded_N,
                          limit_N, theme);
}

std::unique_ptr<PlotView> measuredForcePlot(const SampleSeries& series, double limit_N,
                                            const PlotTheme& theme) {
    return toolsForcePlot(Words::tr("Force measured on each tool"), series, &ToolSamples::measured_N, limit_N,
                          theme);
}

std::unique_ptr<PlotView> speedPlot(const SampleSeries& series, const PlotTheme& theme) {
    auto view = timePlot(series.tools.size() > 1 ? Words::tr("Speed of the tool tips")
                                                 : Words::tr("Speed of the tool tip"),
                         {Words::tr("Speed (mm/s)"), 0.0, {}}, series, theme);
    addTools(*view, series, &ToolSamples::speed_mm_per_s, Words::tr("speed"));
    markCriticalErrors(*view, series, &ToolSamples::speed_mm_per_s);
    finish(*view, series, series.t_s.empty() || firstOf(series, &ToolSamples::speed_mm_per_s).empty());
    return view;
}

std::unique_ptr<PlotView> derivedPlot(const SampleSeries& series, std::string_view id, double factor,
                                      const DerivedWords& words, const PlotTheme& theme) {
    std::vector<double> values;
    for (const double value : series.derivedValues(id))
        values.push_back(factor * value);
    auto view = timePlot(words.title, {words.axis, 0.0, {}}, series, theme);
    view->addLine(words.line, series.t_s, values, PlotStyle::solidA);
    finish(*view, series, series.t_s.empty() || values.empty());
    return view;
}

std::unique_ptr<PlotView> comparisonPlot(const ComparisonData& data, const PlotTheme& theme) {
    auto view = std::make_unique<PlotView>(theme);
    view->setTitle(data.title);
    const QString unit = data.unit.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(data.unit);
    view->setYAxis({data.metricName + unit, 0.0, {}});
    std::vector<QString> names;
    std::vector<PlotPoint> points, means;
    std::vector<double> spreads;
    bool negative = false;
    for (const ComparisonGroup& group : data.groups) {
        const double place = static_cast<double>(names.size());
        names.push_back(QStringLiteral("%1\nn = %2").arg(group.name).arg(group.values.size()));
        for (std::size_t i = 0; i < group.values.size(); ++i) {
            // Shifted sideways, so that equal values stay visible.
            const double aside = 0.03 * (static_cast<double>(i % 5) - 2.0);
            points.push_back({place - 0.14 + aside, group.values[i]});
            negative = negative || group.values[i] < 0.0;
        }
        if (group.values.size() < 2) // a single value has no mean; its point shows it
            continue;
        const double centre = mean(group.values);
        means.push_back({place + 0.12, centre});
        spreads.push_back(deviation(group.values, centre));
        negative = negative || centre - spreads.back() < 0.0;
    }
    if (negative)
        view->setYAxis({data.metricName + unit, {}, {}});
    view->addMarkers(data.pointLabel.isEmpty() ? Words::tr("session") : data.pointLabel, points,
                     PlotStyle::solidA);
    if (!means.empty())
        view->addMeans(Words::tr("mean ± SD"), means, spreads);
    if (data.reference)
        view->addReference(data.referenceLabel, *data.reference);
    view->setXCategories(names);
    if (points.empty())
        view->setNote(Words::tr("No sessions to compare"));
    return view;
}

} // namespace chiron::report
