// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/run_curve_plot.h"

#include "session_report/study_report_text.h"

#include <cmath>

namespace chiron::session_report {

using report::PlotStyle;

namespace {

constexpr double kPercent = 100.0;
constexpr double kPairCriterion = 0.75; ///< proportion correct of two objects that defines Weber fraction and
                                        ///< JND

double percentOf(double difference) {
    return kPercent * (std::pow(10.0, difference) - 1.0);
}

std::vector<double> percentOf(const std::vector<double>& differences) {
    std::vector<double> percents;
    for (const double difference : differences)
        percents.push_back(percentOf(difference));
    return percents;
}

/// Proportion correct for two objects that differ by D, without lapses: Φ(D / (σ √2)).
std::vector<double> rightOfTwo(const std::vector<double>& differences, double sigma_log10) {
    std::vector<double> proportions;
    for (const double difference : differences)
        proportions.push_back(0.5 * std::erfc(-difference / (2.0 * sigma_log10)));
    return proportions;
}

void drawAnswers(report::PlotView& plot, const psychophysics::RunEstimate& estimate) {
    std::vector<report::PlotPoint> points;
    std::vector<int> counts;
    for (const psychophysics::CurvePoint& point : estimate.points)
        if (point.of > 0) {
            points.push_back({percentOf(point.difference), static_cast<double>(point.right) / point.of});
            counts.push_back(point.of);
        }
    if (points.empty())
        return;
    plot.addMarkers(Words::tr("data, with the number of trials"), points, PlotStyle::dashedB);
    plot.addCounts(points, counts);
}

} // namespace

void drawRunCurve(report::PlotView& plot, const psychophysics::RunEstimate& estimate, bool ranks) {
    plot.setXAxis({Words::tr("Difference from the reference (%)"), {}, {}});
    // The range is wider than 0 to 1 so that markers at 0 and 1 are completely visible.
    plot.setYAxis({Words::tr("Proportion correct"), -0.02, 1.06});
    const std::vector<double> x = percentOf(estimate.curveDifference);
    if (!x.empty() && estimate.curveLow.size() == x.size() && estimate.curveHigh.size() == x.size()) {
        plot.addLine(Words::tr("95 % band"), x, estimate.curveLow, PlotStyle::dashDotD);
        plot.addLine({}, x, estimate.curveHigh, PlotStyle::dashDotD);
    }
    if (!x.empty())
        plot.addLine(ranks ? Words::tr("fit: whole order right") : Words::tr("fit"), x,
                     estimate.curveProportion, PlotStyle::solidA);
    const bool pairs = ranks && !x.empty() && estimate.sigma_log10 > 0.0;
    if (pairs)
        plot.addLine(Words::tr("same observer: pair in right order"), x,
                     rightOfTwo(estimate.curveDifference, estimate.sigma_log10), PlotStyle::dottedC);
    drawAnswers(plot, estimate);
    if (pairs)
        plot.addReference(Words::tr("criterion for a pair"), kPairCriterion);
    else if (!ranks && (!x.empty() || !estimate.points.empty()))
        plot.addReference(Words::tr("criterion"), estimate.criterion);
}

} // namespace chiron::session_report
