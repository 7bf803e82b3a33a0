// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/palpation_plots.h"

#include "desktop/playback/playback_plots.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>

namespace chiron::desktop {

namespace {
constexpr double kLeanLimit_deg = 30.0; // limit of the platform (P3)
constexpr std::array<report::PlotStyle, 4> kStyles{report::PlotStyle::solidA, report::PlotStyle::dashedB,
                                                   report::PlotStyle::dottedC, report::PlotStyle::dashDotD};

/// Adds one line per finger for its recorded quantity "<before><finger><after>"; returns false if none was
/// recorded.
bool addFingers(const PlaybackPlots& plots, report::PlotView& view, const char* before, const char* after,
                double factor) {
    const session::PlaybackTrack& track = plots.track();
    const std::vector<double>& t_s = plots.series().t_s;
    bool any = false;
    for (int finger = 0; finger < std::min<int>(track.toolCount, static_cast<int>(kStyles.size()));
         ++finger) {
        const auto* quantity = track.quantity(before + std::to_string(finger) + after);
        if (!quantity || quantity->values.size() != t_s.size())
            continue;
        std::vector<double> values = quantity->values;
        for (double& value : values)
            value *= factor;
        const QString name = track.toolCount > 1
                                 ? PlaybackPlots::tr("finger %1").arg(plots.plotLocale().toString(finger + 1))
                                 : PlaybackPlots::tr("finger");
        view.addLine(name, t_s, values, kStyles[static_cast<std::size_t>(finger)]);
        any = true;
    }
    return any;
}

} // namespace

void addPalpationPlots(PlaybackPlots& plots) {
    if (!plots.track().quantity("lean_0_rad"))
        return;
    const bool several = plots.track().toolCount > 1;
    auto lean = plots.empty(PlaybackPlots::tr("Tilt of the force"));
    if (!addFingers(plots, *lean, "lean_", "_rad", 180.0 / std::numbers::pi))
        return;
    lean->addLimit(PlaybackPlots::tr("maximum tilt of the platform"), kLeanLimit_deg);
    lean->addHatchedSpans(PlaybackPlots::tr("paused"), plots.series().paused);
    plots.add(std::move(lean), "playback.lean_plot",
              {PlaybackPlots::tr("Tilt (°), line: limit of the platform"), 0.0, 90.0, several});
    auto depth = plots.empty(PlaybackPlots::tr("Depth of the fingers"));
    if (!addFingers(plots, *depth, "depth_", "_m", 1e3))
        return;
    depth->addHatchedSpans(PlaybackPlots::tr("paused"), plots.series().paused);
    plots.add(std::move(depth), "playback.depth_plot", {PlaybackPlots::tr("Depth (mm)")});
}

} // namespace chiron::desktop
