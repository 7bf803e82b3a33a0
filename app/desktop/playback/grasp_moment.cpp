// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/playback/grasp_moment.h"

#include "desktop/playback/playback_layer.h"
#include "desktop/playback/playback_plots.h"
#include "report/report_text.h"

#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {

constexpr double kNoise_J = 1e-5; // smaller differences come from rounding in the recording

core::LaparoscopyStep stepOf(double value) {
    const int step = std::clamp(static_cast<int>(std::lround(value)), 0, core::kLastLaparoscopyStep);
    return static_cast<core::LaparoscopyStep>(step);
}

std::vector<double> scaled(const std::vector<double>& values, double factor) {
    std::vector<double> out;
    out.reserve(values.size());
    for (const double value : values)
        out.push_back(factor * value);
    return out;
}

} // namespace

double quantityAt(const session::PlaybackTrack& track, const session::PlaybackView& view,
                  const std::string& id) {
    for (std::size_t i = 0; i < track.quantities.size() && i < view.quantities.size(); ++i)
        if (track.quantities[i].id == id)
            return view.quantities[i];
    return 0.0;
}

std::array<double, 3> placeAt(const session::PlaybackTrack& track, const session::PlaybackView& view,
                              const std::string& name) {
    return {quantityAt(track, view, name + "_x_m"), quantityAt(track, view, name + "_y_m"),
            quantityAt(track, view, name + "_z_m")};
}

core::LaparoscopyCues graspCuesAt(const session::PlaybackTrack& track, const session::PlaybackView& view) {
    core::LaparoscopyCues cues;
    const session::PlaybackTrial* trial = track.trial(view.moment.trial);
    // After a failed trial the remains are shown.
    const bool torn = view.moment.phase == core::TrialPhase::between && trial && trial->failed;
    const bool there = torn || view.moment.phase == core::TrialPhase::ready ||
                       view.moment.phase == core::TrialPhase::running;
    if (!there || track.quantities.empty())
        return cues;
    cues.present = cues.objectShown = true;
    cues.torn = torn;
    cues.step = stepOf(quantityAt(track, view, "step"));
    cues.dwell = quantityAt(track, view, "dwell");
    return cues;
}

void showGrasp(scene3d::SceneState& state, const core::LaparoscopyCues& cues) {
    state.exercise.own<core::LaparoscopyCues>() = cues;
    state.objectShown = cues.objectShown;
    for (scene3d::ToolView& tool : state.tool)
        tool.drawnAtSurface = false; // a jaw that holds something is drawn where the hand is
}

QString graspReadout(const session::PlaybackView& view, const QString& held, const QLocale& locale) {
    const session::PlaybackTool& tool = view.tools.front();
    const QString trial = locale.toString(view.moment.trial + 1);
    const QString force = report::formatValue(tool.tissue_N.norm(), QStringLiteral("N"), locale);
    const QString speed = report::formatValue(1e3 * tool.speed_m_per_s, QStringLiteral("mm/s"), locale);
    return view.moment.paused
               ? PlaybackTexts::tr("Trial %1 · %2 · %3 · force %4 · speed %5")
                     .arg(trial, stillWords(view.moment), held, force, speed)
               : PlaybackTexts::tr("Trial %1 · %2 · force %3 · speed %4").arg(trial, held, force, speed);
}

std::vector<report::TimeSpan> excessEnergy(const std::vector<double>& t_s, const std::vector<double>& in,
                                           const std::vector<double>& held) {
    std::vector<report::TimeSpan> spans;
    bool open = false;
    for (std::size_t i = 0; i < t_s.size(); ++i) {
        const bool more = held[i] > in[i] + kNoise_J;
        if (more && !open)
            spans.push_back({t_s[i], t_s[i]});
        if (more)
            spans.back().end_s = t_s[i];
        open = more;
    }
    return spans;
}

void addEnergyPlot(PlaybackPlots& plots) {
    const session::PlaybackQuantity* in = plots.track().quantity("energy_supplied_J");
    const session::PlaybackQuantity* held = plots.track().quantity("energy_stored_J");
    if (!plots.books() || !in || !held || in->values.empty() || held->values.size() != in->values.size())
        return;
    auto view = plots.empty(PlaybackPlots::tr("Energy supplied by the hand and stored in the object"));
    const std::vector<report::TimeSpan> excess = excessEnergy(plots.series().t_s, in->values, held->values);
    if (!excess.empty())
        view->addHatchedSpans(PlaybackPlots::tr("more stored than supplied"), excess);
    view->addLine(PlaybackPlots::tr("supplied"), plots.series().t_s, scaled(in->values, 1e3),
                  report::PlotStyle::dashedB);
    view->addLine(PlaybackPlots::tr("stored"), plots.series().t_s, scaled(held->values, 1e3),
                  report::PlotStyle::solidA);
    plots.add(std::move(view), "playback.energy_plot", {PlaybackPlots::tr("Energy (mJ)"), {}, {}, true});
}

} // namespace chiron::desktop
