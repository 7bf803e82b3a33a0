// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/desktop/insertion_layer.h"

#include "app/exercises/urethra_insertion/desktop/stage_words.h"
#include "app/exercises/urethra_insertion/report/insertion_report.h"
#include "app/exercises/urethra_insertion/session/playback_insertion.h"
#include "desktop/playback/playback_plots.h"
#include "desktop/plots/plot_theme_of.h"
#include "report/report_text.h"

#include <cmath>
#include <numbers>

namespace chiron::desktop {

namespace {

constexpr char kDepthOfField[] = "depth_of_field";

/// The state of the procedure at a moment, as far as the recording contains it.
simulation::EndoscopeCues endoscopeOf(const session::PlaybackInsertion& insertion,
                                      const session::PlaybackInsertionMoment& moment, double t_s) {
    simulation::EndoscopeCues cues;
    cues.present = true;
    cues.pictureShown = true;
    cues.guided = true;
    cues.stage = moment.stage;
    cues.depth_m = std::isfinite(moment.depth_m) ? moment.depth_m : 0.0;
    cues.landmarks = static_cast<int>(insertion.landmarkSeen_s.size());
    cues.landmarksSeen = insertion.landmarksSeenAt(t_s);
    return cues;
}

} // namespace

std::vector<PlaybackSwitch> InsertionLayer::switches() const {
    return {{kDepthOfField, PlaybackTexts::tr("Depth of field"),
             PlaybackTexts::tr("The picture is sharp at one distance only, as through a real endoscope"),
             m_depthOfField, true}};
}

void InsertionLayer::turn(std::string_view key, bool on) {
    if (key == kDepthOfField)
        m_depthOfField = on;
}

void InsertionLayer::setUp(scene3d::SceneSetup& setup) const {
    setup.depthOfField = m_depthOfField;
}

void InsertionLayer::showIn(scene3d::SceneState& state, const session::PlaybackTrack& track,
                            const session::PlaybackView&, double t_s) {
    const auto moment = session::insertionAt(track, t_s);
    if (!moment)
        return;
    state.objectShown = true; // the object is the endoscope's picture
    state.exercise.own<simulation::EndoscopeCues>() =
        endoscopeOf(*track.of<session::PlaybackInsertion>(), *moment, t_s);
}

QString InsertionLayer::readout(const session::PlaybackTrack& track, const session::PlaybackView& view,
                                double t_s, const QLocale& locale) const {
    const auto moment = session::insertionAt(track, t_s);
    if (!moment)
        return trialReadout(view, locale);
    const session::PlaybackTool& tool = view.tools.front();
    const QString force = report::formatValue(tool.tissue_N.norm(), QStringLiteral("N"), locale);
    const QString speed = report::formatValue(1e3 * tool.speed_m_per_s, QStringLiteral("mm/s"), locale);
    const QString stage = stageTitle(moment->stage);
    const QString depth = report::formatValue(1e3 * moment->depth_m, QStringLiteral("mm"), locale);
    return view.moment.paused
               ? PlaybackTexts::tr("%1 · %2 · depth %3 · force %4 · speed %5")
                     .arg(stage, stillWords(view.moment), depth, force, speed)
               : PlaybackTexts::tr("%1 · depth %2 · force %3 · speed %4").arg(stage, depth, force, speed);
}

void InsertionLayer::addPlots(PlaybackPlots& plots) const {
    if (plots.series().derivedValues(session::kOffsetSeries).empty())
        return;
    const report::PlotTheme look = plotThemeOf(plots.theme(), plots.plotLocale());
    auto offset = report::offsetPlot(plots.series(), session::kOffsetSeries, look);
    plots.addSecond(*offset, session::kOffsetSeries, 1e3);
    plots.add(std::move(offset), "playback.offset_plot", {PlaybackPlots::tr("Off-centre (mm)")});
    auto alignment = report::alignmentPlot(plots.series(), session::kAlignmentSeries, look);
    plots.addSecond(*alignment, session::kAlignmentSeries, 180.0 / std::numbers::pi);
    plots.add(std::move(alignment), "playback.alignment_plot", {PlaybackPlots::tr("Alignment (°)")});
}

} // namespace chiron::desktop
