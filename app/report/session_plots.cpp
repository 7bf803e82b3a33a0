// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/session_plots.h"

#include "report/report_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::report {

namespace {

constexpr int kLateShape = 2; // of addGroupMarkers: neither a mark's nor a miss's

std::unique_ptr<PlotView> timePlot(const QString& title, const PlotAxis& yAxis, const SampleSeries& series,
                                   const PlotTheme& theme) {
    auto view = std::make_unique<PlotView>(theme);
    view->setTitle(title);
    PlotAxis time{Words::tr("Time (s)"), std::nullopt, std::nullopt};
    if (series.t_s.size() > 1) { // the whole session and no more
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

double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

// Sample standard deviation (n - 1); not a number for fewer than two values: there is none.
double deviation(const std::vector<double>& values, double centre) {
    if (values.size() < 2)
        return std::numeric_limits<double>::quiet_NaN();
    double squares = 0.0;
    for (const double value : values)
        squares += (value - centre) * (value - centre);
    return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

} // namespace

std::unique_ptr<PlotView> positionPlot(const SampleSeries& series, const PlotTheme& theme) {
    auto view =
        timePlot(Words::tr("Position of the tool tip"), {Words::tr("Position (mm)"), {}, {}}, series, theme);
    view->addLine(QStringLiteral("x"), series.t_s, series.x_mm, PlotStyle::solidA);
    view->addLine(QStringLiteral("y"), series.t_s, series.y_mm, PlotStyle::dashedB);
    view->addLine(QStringLiteral("z"), series.t_s, series.z_mm, PlotStyle::dottedC);
    finish(*view, series, series.t_s.empty() || series.x_mm.empty());
    return view;
}

std::unique_ptr<PlotView> forcePlot(const SampleSeries& series, double limit_N, const PlotTheme& theme) {
    auto view = timePlot(Words::tr("Force on the tool"), {Words::tr("Force (N)"), 0.0, {}}, series, theme);
    view->shadeAbove(Words::tr("over the limit"), series.t_s, series.tissue_N, limit_N);
    // What is assessed is drawn last, on top.
    if (!series.measured_N.empty())
        view->addLine(Words::tr("measured"), series.t_s, series.measured_N, PlotStyle::dottedC);
    if (!series.commanded_N.empty())
        view->addLine(Words::tr("felt (commanded)"), series.t_s, series.commanded_N, PlotStyle::dashedB);
    view->addLine(Words::tr("tissue (assessed)"), series.t_s, series.tissue_N, PlotStyle::solidA);
    view->addLimit(Words::tr("limit %1").arg(formatValue(limit_N, QStringLiteral("N"), theme.locale)),
                   limit_N);
    finish(*view, series, series.t_s.empty() || series.tissue_N.empty());
    return view;
}

std::unique_ptr<PlotView> speedPlot(const SampleSeries& series, const PlotTheme& theme) {
    auto view =
        timePlot(Words::tr("Speed of the tool tip"), {Words::tr("Speed (mm/s)"), 0.0, {}}, series, theme);
    view->addLine(Words::tr("speed"), series.t_s, series.speed_mm_per_s, PlotStyle::solidA);
    finish(*view, series, series.t_s.empty() || series.speed_mm_per_s.empty());
    return view;
}

std::unique_ptr<PlotView> offsetPlot(const SampleSeries& series, const PlotTheme& theme) {
    auto view = timePlot(Words::tr("Distance from the middle of the canal"), {Words::tr("Off-centre (mm)"), 0.0, {}}, series, theme);
    view->addLine(Words::tr("off-centre"), series.t_s, series.offset_mm, PlotStyle::solidA);
    finish(*view, series, series.t_s.empty() || series.offset_mm.empty());
    return view;
}

std::unique_ptr<PlotView> alignmentPlot(const SampleSeries& series, const PlotTheme& theme) {
    auto view = timePlot(Words::tr("Angle between endoscope and canal"), {Words::tr("Alignment (°)"), 0.0, {}}, series, theme);
    view->addLine(Words::tr("alignment"), series.t_s, series.alignment_deg, PlotStyle::solidA);
    finish(*view, series, series.t_s.empty() || series.alignment_deg.empty());
    return view;
}

namespace {

/// One quantity over depth: in and out.
std::unique_ptr<PlotView> depthPlot(const QString& title, const QString& axis, const InsertionProfile& profile,
                                    const std::vector<double>& in, const std::vector<double>& out, const PlotTheme& theme) {
    auto view = std::make_unique<PlotView>(theme);
    view->setTitle(title);
    const auto isNumber = [](double value) { return std::isfinite(value); };
    const bool entered = std::any_of(in.begin(), in.end(), isNumber);
    const double deepest = profile.depth_mm.empty() ? 0.0 : profile.depth_mm.back();
    view->setXAxis({Words::tr("Depth (mm)"), std::min(0.0, profile.depth_mm.empty() ? 0.0 : profile.depth_mm.front()),
                    std::max({deepest, profile.goal_mm, 1.0})});
    view->setYAxis({axis, 0.0, {}});
    view->addLine(Words::tr("in"), profile.depth_mm, in, PlotStyle::solidA);
    if (std::any_of(out.begin(), out.end(), isNumber))
        view->addLine(Words::tr("out"), profile.depth_mm, out, PlotStyle::dashedB);
    const double end_mm = std::max(deepest, profile.goal_mm);
    std::vector<TimedEvent> places;
    for (const auto& [at_mm, name] : {std::pair{profile.bend_mm, Words::tr("bend")}, std::pair{profile.neck_mm, Words::tr("bladder neck")}})
        if (at_mm > 0.0 && at_mm <= end_mm)
            places.push_back({at_mm, name});
    view->addEvents(places);
    if (!entered)
        view->setNote(Words::tr("The endoscope did not enter"));
    return view;
}

} // namespace

std::unique_ptr<PlotView> offsetDepthPlot(const InsertionProfile& profile, const PlotTheme& theme) {
    return depthPlot(Words::tr("Off-centre, largest in each millimetre"), Words::tr("Off-centre (mm)"), profile, profile.offsetIn_mm,
                     profile.offsetOut_mm, theme);
}

std::unique_ptr<PlotView> alignmentDepthPlot(const InsertionProfile& profile, const PlotTheme& theme) {
    return depthPlot(Words::tr("Alignment, largest in each millimetre"), Words::tr("Alignment (°)"), profile, profile.alignmentIn_deg,
                     profile.alignmentOut_deg, theme);
}

std::unique_ptr<PlotView> apexScatterPlot(const std::vector<ApexError>& errors, const PlotTheme& theme) {
    auto view = std::make_unique<PlotView>(theme);
    view->setTitle(Words::tr("Where the marks lie on the sphere"));
    view->setXAxis({Words::tr("Error in x (% of radius)"), {}, {}});
    view->setYAxis({Words::tr("Error in y (% of radius)"), {}, {}});
    view->setEqualScale(true);
    view->addCircle(Words::tr("outline"), 100.0);
    std::vector<PlotPoint> hits, misses, late;
    for (const ApexError& error : errors)
        (error.timedOut ? late : error.miss ? misses : hits).push_back({error.x_percent, error.y_percent});
    if (!hits.empty() || errors.empty())
        view->addMarkers(Words::tr("mark"), hits, PlotStyle::solidA);
    if (!misses.empty())
        view->addMarkers(Words::tr("miss"), misses, PlotStyle::solidA, true);
    if (!late.empty())
        view->addGroupMarkers(Words::tr("no mark: time was up"), late, kLateShape);
    if (errors.empty())
        view->setNote(Words::tr("No trial was marked"));
    return view;
}

std::unique_ptr<PlotView> apexTrialPlot(const std::vector<ApexError>& errors, const PlotTheme& theme) {
    auto view = std::make_unique<PlotView>(theme);
    view->setTitle(Words::tr("% error in locating virtual spheres"));
    view->setXAxis({Words::tr("Trial"), {}, {}});
    view->setYAxis({Words::tr("Error (% of radius)"), {}, {}});
    std::vector<QString> names;
    std::vector<PlotPoint> x, y, misses, late;
    for (const ApexError& error : errors) {
        const double place = static_cast<double>(names.size());
        names.push_back(QString::number(error.trial + 1));
        x.push_back({place, error.x_percent});
        y.push_back({place, error.y_percent});
        if (error.timedOut || error.miss)
            (error.timedOut ? late : misses).push_back({place, 0.0});
    }
    view->addBars(QStringLiteral("x"), x, PlotStyle::solidA, 0, 2);
    view->addBars(QStringLiteral("y"), y, PlotStyle::dashedB, 1, 2);
    if (!misses.empty())
        view->addMarkers(Words::tr("miss"), misses, PlotStyle::solidA, true);
    if (!late.empty())
        view->addGroupMarkers(Words::tr("no mark: time was up"), late, kLateShape);
    view->setXCategories(names);
    if (errors.empty())
        view->setNote(Words::tr("No trial was marked"));
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
            const double aside = 0.03 * (static_cast<double>(i % 5) - 2.0); // equal values stay visible
            points.push_back({place - 0.14 + aside, group.values[i]});
            negative = negative || group.values[i] < 0.0;
        }
        if (group.values.empty())
            continue;
        const double centre = mean(group.values);
        means.push_back({place + 0.12, centre});
        spreads.push_back(deviation(group.values, centre));
        negative = negative || centre - spreads.back() < 0.0;
    }
    if (negative)
        view->setYAxis({data.metricName + unit, {}, {}});
    view->addMarkers(data.pointLabel.isEmpty() ? Words::tr("session") : data.pointLabel, points, PlotStyle::solidA);
    view->addMeans(Words::tr("mean ± SD"), means, spreads);
    if (data.reference)
        view->addReference(data.referenceLabel, *data.reference);
    view->setXCategories(names);
    if (points.empty())
        view->setNote(Words::tr("No sessions to compare"));
    return view;
}

} // namespace chiron::report
