// SPDX-License-Identifier: GPL-3.0-or-later
// How far the force leaned and how deep the fingers were, over time.
#include "desktop/playback/playback_plots.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <string>

namespace chiron::desktop {

namespace {
constexpr int kHeight_px = 134;
constexpr double kLeanLimit_deg = 30.0; // of the platform (P3)
constexpr std::array<report::PlotStyle, 4> kStyles{report::PlotStyle::solidA, report::PlotStyle::dashedB, report::PlotStyle::dottedC,
                                                  report::PlotStyle::dashDotD};
} // namespace

bool PlaybackPlots::addFingers(report::PlotView& view, const char* before, const char* after, double factor) const {
    bool any = false;
    for (int finger = 0; finger < std::min<int>(m_track.toolCount, static_cast<int>(kStyles.size())); ++finger) {
        const auto* quantity = m_track.quantity(before + std::to_string(finger) + after);
        if (!quantity || quantity->values.size() != m_series.t_s.size())
            continue;
        std::vector<double> values = quantity->values;
        for (double& value : values)
            value *= factor;
        const QString name = m_track.toolCount > 1 ? tr("finger %1").arg(m_locale.toString(finger + 1)) : tr("finger");
        view.addLine(name, m_series.t_s, values, kStyles[static_cast<std::size_t>(finger)]);
        any = true;
    }
    return any;
}

void PlaybackPlots::putPalpation() {
    if (!m_track.quantity("lean_0_rad"))
        return;
    auto lean = empty(tr("Tilt of the force"));
    if (!addFingers(*lean, "lean_", "_rad", 180.0 / std::numbers::pi))
        return;
    lean->addLimit(tr("maximum tilt of the platform"), kLeanLimit_deg);
    lean->addHatchedSpans(tr("paused"), m_series.paused);
    slim(*lean, {});
    lean->setYAxis({QString(), 0.0, 90.0});
    lean->setTitle(tr("Tilt (°), line: limit of the platform"));
    lean->setLegendShown(m_track.toolCount > 1);
    put(std::move(lean), m_lean, "playback.lean_plot", kHeight_px);
    auto depth = empty(tr("Depth of the fingers"));
    if (!addFingers(*depth, "depth_", "_m", 1e3))
        return;
    depth->addHatchedSpans(tr("paused"), m_series.paused);
    slim(*depth, {});
    depth->setYAxis({QString(), 0.0, {}});
    depth->setTitle(tr("Depth (mm)"));
    depth->setLegendShown(false);
    put(std::move(depth), m_depth, "playback.depth_plot", kHeight_px);
}

} // namespace chiron::desktop
