// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/elastic_tube/desktop/tube_layer.h"

#include "app/exercises/elastic_tube/session/planned_tube.h"
#include "desktop/playback/grasp_moment.h"
#include "desktop/playback/playback_plots.h"
#include "report/report_text.h"
#include "simulation/tube/tube_segment.h"

#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace chiron::desktop {

using simulation::TubeTask;

namespace {

std::array<double, 3> arrayOf(const core::Vec3& v) {
    return {v.x(), v.y(), v.z()};
}
core::Vec3 vecOf(const std::array<double, 3>& v) {
    return {v[0], v[1], v[2]};
}

/// The tip of the tool that holds a grip; empty if nobody holds it.
std::optional<core::Vec3> holderOf(const session::PlaybackView& view, std::uint8_t mask) {
    for (std::size_t i = 0; i < view.tools.size(); ++i)
        if ((mask >> i & 1) != 0)
            return view.tools[i].p_WT;
    return std::nullopt;
}

struct Stepped {
    std::vector<double> t_s;
    std::vector<double> low;
    std::vector<double> high;
};

/// The band of each trial over its duration, with gaps between trials.
Stepped bands(const session::PlaybackTrack& track, const TubeLayer& tube) {
    constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
    Stepped steps;
    for (const session::PlaybackTrial& trial : track.trials) {
        const TubeLayer::Band band = tube.bandOf(trial.index);
        if (!(band.high_N > 0.0))
            continue;
        for (const double t : {trial.start_s, trial.end_s}) {
            steps.t_s.push_back(t);
            steps.low.push_back(band.low_N);
            steps.high.push_back(band.high_N);
        }
        steps.t_s.push_back(trial.end_s);
        steps.low.push_back(kGap);
        steps.high.push_back(kGap);
    }
    return steps;
}

} // namespace

TubeLayer::TubeLayer(const simulation::ElasticTubeParameters& level, std::uint64_t seed)
    : m_level(level), m_trials(simulation::planElasticTubeTrials(level, seed)),
      m_truths(session::plannedTubes(level, seed)) {}

TubeLayer::Band TubeLayer::bandOf(int trial) const {
    const auto i = static_cast<std::size_t>(trial);
    if (trial < 0 || i >= m_truths.size() || !m_truths[i].target_N || !m_truths[i].band_N)
        return {};
    return {*m_truths[i].target_N - *m_truths[i].band_N, *m_truths[i].target_N + *m_truths[i].band_N};
}

core::LaparoscopyCues TubeLayer::cuesAt(const session::PlaybackTrack& track,
                                        const session::PlaybackView& view) const {
    core::LaparoscopyCues cues = graspCuesAt(track, view);
    if (cues.present && view.moment.trial < m_trials.size())
        fillTube(track, view, cues);
    return cues;
}

void TubeLayer::fillTube(const session::PlaybackTrack& track, const session::PlaybackView& view,
                         core::LaparoscopyCues& cues) const {
    const simulation::ElasticTubeTrial& trial = m_trials[view.moment.trial];
    const bool anchored = m_level.task != TubeTask::twoHanded;
    cues.tube = true;
    cues.restLength_m = m_level.restLength_m;
    cues.grips = m_level.task == TubeTask::transfer ? 3 : 2;
    cues.gripAt = {0.0, cues.grips == 3 ? m_level.gripShare : 1.0, 1.0};
    cues.gripAnchored[0] = anchored;
    for (std::size_t i = 0; i < 3; ++i)
        cues.gripHeldBy[i] =
            static_cast<std::uint8_t>(std::lround(quantityAt(track, view, "grip_" + std::to_string(i))));
    const auto last = static_cast<std::size_t>(cues.grips - 1);
    const core::Vec3 base(trial.base_m.x(), trial.base_m.y(), 0.0);
    const core::Vec3 end = vecOf(placeAt(track, view, "free_end"));
    cues.p_WGrip[last] = arrayOf(end);
    // The other end of an unfixed tube is at its holder's tip. If nobody holds it, it was dragged along and
    // lies one rest length away.
    const core::Vec3 lying = core::Vec3(end.x() - m_level.restLength_m, end.y(), m_level.radius_m);
    cues.p_WGrip[0] = arrayOf(anchored ? base : holderOf(view, cues.gripHeldBy[0]).value_or(lying));
    // A held grip is at its holder's tip; a free one follows the tube.
    if (cues.grips == 3)
        cues.p_WGrip[1] =
            arrayOf(holderOf(view, cues.gripHeldBy[1])
                        .value_or(simulation::tubePlace(vecOf(cues.p_WGrip[0]), end, m_level.restLength_m,
                                                        m_level.gripShare)));
    cues.stretch_m = quantityAt(track, view, "stretch_m");
    if (m_level.hasFold())
        fillFold(track, view, cues);
    cues.tensionShown = true;
    cues.tension_N = quantityAt(track, view, "tension_N");
    const Band band = bandOf(view.moment.trial);
    cues.bandLow_N = band.low_N;
    cues.bandHigh_N = band.high_N;
    if (m_level.task == TubeTask::transfer) {
        cues.targetShown = true;
        cues.p_WTarget = {m_level.targetX_m, m_level.targetY_m, m_level.targetZ_m};
        cues.targetRadius_m = m_level.targetRadius_m;
    }
    cues.targetShown = cues.targetShown || m_level.task == TubeTask::stretch;
}

void TubeLayer::fillFold(const session::PlaybackTrack& track, const session::PlaybackView& view,
                         core::LaparoscopyCues& cues) const {
    cues.fold = cues.retractionShown = true;
    cues.p_WFoldEdge = placeAt(track, view, "fold_edge");
    cues.p_WFoldBase = arrayOf(simulation::tissueFoldShape(m_level, m_trials[view.moment.trial]).base);
    cues.foldOpen = quantityAt(track, view, "fold_open") > 0.5;
    cues.retraction_N = quantityAt(track, view, "retraction_N");
    cues.foldHeldBy = static_cast<std::uint8_t>(
        cues.retraction_N > 0.0 ? 1U << static_cast<unsigned>(m_level.retractor()) : 0U);
    cues.retractionLow_N = m_level.retractionLow_N;
    cues.retractionHigh_N = m_level.retractionHigh_N;
}

void TubeLayer::showIn(scene3d::SceneState& state, const session::PlaybackTrack& track,
                       const session::PlaybackView& view, double) {
    showGrasp(state, cuesAt(track, view));
}

QString TubeLayer::readout(const session::PlaybackTrack& track, const session::PlaybackView& view, double,
                           const QLocale& locale) const {
    const double tension_N = cuesAt(track, view).tension_N;
    return graspReadout(
        view,
        PlaybackTexts::tr("tension %1").arg(report::formatValue(tension_N, QStringLiteral("N"), locale)),
        locale);
}

void TubeLayer::addPlots(PlaybackPlots& plots) const {
    addTension(plots);
    addRetraction(plots);
    addEnergyPlot(plots);
}

void TubeLayer::addTension(PlaybackPlots& plots) const {
    const session::PlaybackQuantity* tension = plots.track().quantity("tension_N");
    if (!tension || tension->values.empty())
        return;
    auto view = plots.empty(PlaybackPlots::tr("Tension of the tube"));
    const Stepped steps = bands(plots.track(), *this);
    if (!steps.t_s.empty()) {
        view->addLine(PlaybackPlots::tr("band, from"), steps.t_s, steps.low, report::PlotStyle::dashedB);
        view->addLine(PlaybackPlots::tr("band, to"), steps.t_s, steps.high, report::PlotStyle::dashedB);
    }
    view->addLine(PlaybackPlots::tr("tension"), plots.series().t_s, tension->values,
                  report::PlotStyle::solidA);
    view->addHatchedSpans(PlaybackPlots::tr("paused"), plots.series().paused);
    plots.add(std::move(view), "playback.grasp_plot",
              {PlaybackPlots::tr("Tension (N), dashed: target band")});
}

void TubeLayer::addRetraction(PlaybackPlots& plots) const {
    const session::PlaybackQuantity* pull = plots.track().quantity("retraction_N");
    if (!pull || pull->values.empty())
        return;
    const std::vector<double>& t_s = plots.series().t_s;
    auto view = plots.empty(PlaybackPlots::tr("Pull on the fold of tissue"));
    const Band band = retractionBand();
    const std::vector<double> ends{t_s.empty() ? 0.0 : t_s.front(), t_s.empty() ? 0.0 : t_s.back()};
    view->addLine(PlaybackPlots::tr("band, from"), ends, std::vector<double>(2, band.low_N),
                  report::PlotStyle::dashedB);
    view->addLine(PlaybackPlots::tr("band, to"), ends, std::vector<double>(2, band.high_N),
                  report::PlotStyle::dashedB);
    view->addLine(PlaybackPlots::tr("pull"), t_s, pull->values, report::PlotStyle::solidA);
    view->addHatchedSpans(PlaybackPlots::tr("paused"), plots.series().paused);
    plots.add(std::move(view), "playback.retraction_plot",
              {PlaybackPlots::tr("Pull on the fold (N), dashed: target band")});
}

} // namespace chiron::desktop
