// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/object_handling/desktop/handling_layer.h"

#include "app/exercises/object_handling/session/planned_handling.h"
#include "desktop/playback/grasp_moment.h"
#include "desktop/playback/playback_plots.h"
#include "report/report_text.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace chiron::desktop {

HandlingLayer::HandlingLayer(const simulation::ObjectHandlingParameters& level, std::uint64_t seed)
    : m_level(level), m_truths(session::plannedHandling(level, seed)) {}

core::LaparoscopyCues HandlingLayer::cuesAt(const session::PlaybackTrack& track,
                                            const session::PlaybackView& view) const {
    core::LaparoscopyCues cues = graspCuesAt(track, view);
    if (cues.present && view.moment.trial < m_truths.size())
        fillObjects(track, view, cues);
    return cues;
}

void HandlingLayer::fillObjects(const session::PlaybackTrack& track, const session::PlaybackView& view,
                                core::LaparoscopyCues& cues) const {
    const scoring::HandlingTruth& truth = m_truths[view.moment.trial];
    const int held = static_cast<int>(std::lround(quantityAt(track, view, "held"))) - 1;
    cues.squeezeShown = true;
    cues.squeeze_N[0] = quantityAt(track, view, "squeeze_N");
    cues.squeezeLimit_N = truth.squeezeLimit_N.value_or(0.0);
    cues.bodies = std::min(truth.objects.value_or(0), static_cast<int>(core::LaparoscopyCues::kMaxBodies));
    for (int i = 0; i < cues.bodies; ++i) {
        core::BodyCue& body = cues.body[static_cast<std::size_t>(i)];
        body.p_W = placeAt(track, view, "body_" + std::to_string(i));
        body.radius_m = m_level.radius_m;
        if (i != held)
            continue;
        body.heldBy = 1;
        // The opening of the jaws equals the remaining thickness of the object.
        const double opening_m =
            2.0 * m_level.jawLength_m * std::sin(0.5 * (view.tools.empty() ? 0.0 : view.tools[0].jaw_rad));
        body.squeeze_m = std::max(0.0, 2.0 * m_level.radius_m - opening_m);
    }
    cues.targetShown = true;
    cues.p_WTarget = {truth.targetX_m.value_or(0.0), truth.targetY_m.value_or(0.0), 0.0};
    cues.targetRadius_m = truth.targetRadius_m.value_or(0.0);
}

void HandlingLayer::showIn(scene3d::SceneState& state, const session::PlaybackTrack& track,
                           const session::PlaybackView& view, double) {
    showGrasp(state, cuesAt(track, view));
}

QString HandlingLayer::readout(const session::PlaybackTrack& track, const session::PlaybackView& view, double,
                               const QLocale& locale) const {
    const core::LaparoscopyCues cues = cuesAt(track, view);
    const QString held = report::formatValue(cues.squeeze_N[0], QStringLiteral("N"), locale);
    return graspReadout(view,
                        cues.squeezeShown ? PlaybackTexts::tr("squeeze %1").arg(held)
                                          : PlaybackTexts::tr("tension %1").arg(held),
                        locale);
}

void HandlingLayer::addPlots(PlaybackPlots& plots) const {
    if (const session::PlaybackQuantity* squeeze = plots.track().quantity("squeeze_N");
        squeeze && !squeeze->values.empty()) {
        auto view = plots.empty(PlaybackPlots::tr("Squeeze of the jaws"));
        view->shadeAbove(PlaybackPlots::tr("over the limit"), plots.series().t_s, squeeze->values,
                         m_level.squeezeLimit_N);
        view->addLimit(PlaybackPlots::tr("limit"), m_level.squeezeLimit_N);
        view->addLine(PlaybackPlots::tr("squeeze"), plots.series().t_s, squeeze->values,
                      report::PlotStyle::solidA);
        view->addHatchedSpans(PlaybackPlots::tr("paused"), plots.series().paused);
        plots.add(std::move(view), "playback.grasp_plot", {PlaybackPlots::tr("Squeeze (N)")});
    }
    addEnergyPlot(plots);
}

} // namespace chiron::desktop
