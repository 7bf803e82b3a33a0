// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cues/laparoscopy_cues.h"
#include "desktop/scene3d/gauge_painter.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"

namespace chiron::scene3d {

/// The end of the tension scale: a value above the band, or the largest force of the level.
inline double tensionEnd_N(const simulation::ElasticTubeParameters& tube) {
    const bool band = tube.task == simulation::TubeTask::hold || tube.task == simulation::TubeTask::twoHanded;
    return band ? 1.5 * (tube.targetHigh_N + tube.band_N) : tube.maximumForce_N;
}

/// The bar of the tube's tension with its band. The scale comes from the level, the band from the cues. Pure
/// function.
inline SecondBar tensionBar(const simulation::ElasticTubeParameters& tube,
                            const core::LaparoscopyCues& cues) {
    SecondBar bar;
    bar.dial.title = GaugeTexts::tr("Tension (N)");
    bar.dial.range_N = endOfScale_N(tensionEnd_N(tube));
    bar.dial.bandLow_N = cues.bandLow_N;
    bar.dial.bandHigh_N = cues.bandHigh_N;
    bar.shown = cues.present && cues.tensionShown;
    bar.value_N = cues.tension_N;
    return bar;
}

} // namespace chiron::scene3d
