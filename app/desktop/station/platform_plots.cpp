// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units.h"
#include "desktop/station/platform_card.h"
#include "report/plot_view.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>

namespace chiron::desktop {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(PlatformPlots)
};

constexpr double kAxis_deg = 35.0;
constexpr double kBin_deg = 0.25;

std::unique_ptr<report::PlotView> titled(const QString& title, const report::PlotTheme& look) {
    auto view = std::make_unique<report::PlotView>(look);
    view->setTitle(title);
    view->setAccessibleName(title);
    return view;
}

} // namespace

std::unique_ptr<report::PlotView> platformSinePlot(const PlatformCheck& check,
                                                   const report::PlotTheme& look) {
    const auto& series = check.verified.series;
    auto view = titled(Words::tr("Force over three cycles"), look);
    view->setXAxis({Words::tr("Time (s)"), {}, {}});
    view->setYAxis({Words::tr("Force (N)"), {}, {}});
    view->addLine(Words::tr("measured"), series.time_s, series.measured_N, report::PlotStyle::solidA);
    view->addLine(Words::tr("on the fingertip"), series.time_s, series.true_N, report::PlotStyle::dottedC);
    view->addLine(Words::tr("target"), series.time_s, series.reference_N, report::PlotStyle::dashedB);
    return view;
}

std::unique_ptr<report::PlotView> platformPosePlot(const PlatformCheck& check,
                                                   const report::PlotTheme& look) {
    auto view = titled(Words::tr("Orientations, measured against target"), look);
    view->setXAxis({Words::tr("Target (°)"), -kAxis_deg, kAxis_deg});
    view->setYAxis({Words::tr("Measured (°)"), -kAxis_deg, kAxis_deg});
    constexpr std::array<double, 2> kEnds{-kAxis_deg, kAxis_deg};
    view->addLine(Words::tr("ideal"), kEnds, kEnds, report::PlotStyle::dashDotD);
    std::vector<report::PlotPoint> pitch;
    std::vector<report::PlotPoint> roll;
    for (const mechanisms::FingertipPosed& pose : check.verified.poses) {
        pitch.push_back(
            {core::degFromRad(pose.referencePitch_rad), core::degFromRad(pose.measuredPitch_rad)});
        roll.push_back({core::degFromRad(pose.referenceRoll_rad), core::degFromRad(pose.measuredRoll_rad)});
    }
    view->addMarkers(Words::tr("pitch"), pitch, report::PlotStyle::solidA);
    view->addMarkers(Words::tr("roll"), roll, report::PlotStyle::dashedB, true);
    return view;
}

std::unique_ptr<report::PlotView> platformErrorPlot(const PlatformCheck& check,
                                                    const report::PlotTheme& look) {
    auto view = titled(Words::tr("Distribution of the orientation errors"), look);
    std::vector<report::PlotPoint> bins;
    for (const mechanisms::FingertipPosed& pose : check.verified.poses) {
        const double error_deg = core::degFromRad(std::hypot(pose.referencePitch_rad - pose.measuredPitch_rad,
                                                             pose.referenceRoll_rad - pose.measuredRoll_rad));
        const auto bin = static_cast<std::size_t>(std::min(error_deg / kBin_deg, 200.0));
        while (bins.size() <= bin)
            bins.push_back({(static_cast<double>(bins.size()) + 0.5) * kBin_deg, 0.0});
        bins[bin].y += 1.0;
    }
    view->setXAxis({Words::tr("Error (°)"), 0.0,
                    std::max<double>(2.5, (static_cast<double>(bins.size()) + 1.0) * kBin_deg)});
    view->setYAxis({Words::tr("Poses"), 0.0, {}});
    view->setYWholeNumbers();
    std::vector<double> x;
    std::vector<double> y;
    for (const report::PlotPoint& bin : bins) { // one step per bin, as wide as the bin
        x.insert(x.end(), {bin.x - 0.5 * kBin_deg, bin.x + 0.5 * kBin_deg});
        y.insert(y.end(), {bin.y, bin.y});
    }
    view->addLine(Words::tr("poses"), x, y, report::PlotStyle::solidA);
    view->setLegendShown(false);
    return view;
}

} // namespace chiron::desktop
