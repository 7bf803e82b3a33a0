// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cues/laparoscopy_cues.h"
#include "desktop/scene3d/gauge_painter.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"

#include <algorithm>

namespace chiron::scene3d {

/// The bar of the jaws' squeeze with its limit. The scale comes from the level, the limit from the cues. Pure
/// function.
inline SecondBar squeezeBar(const simulation::ObjectHandlingParameters& level,
                            const core::LaparoscopyCues& cues) {
    SecondBar bar;
    bar.dial.title = GaugeTexts::tr("Squeeze (N)");
    bar.dial.limit_N = cues.squeezeLimit_N;
    bar.dial.range_N = endOfScale_N(1.5 * level.squeezeLimit_N);
    bar.shown = cues.present && cues.squeezeShown;
    bar.value_N = *std::max_element(cues.squeeze_N.begin(), cues.squeeze_N.end());
    return bar;
}

} // namespace chiron::scene3d
