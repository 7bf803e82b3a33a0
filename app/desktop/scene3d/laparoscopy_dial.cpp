// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/laparoscopy_dial.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(chiron::scene3d::ForceGauge)
};

/// The end of a scale that leaves room above `most_N`, in halves of a newton.
double endOfScale_N(double most_N) { return std::max(1.0, std::ceil(2.0 * most_N) / 2.0); }

} // namespace

std::optional<GaugeDial> laparoscopyDial(const SceneSetup& setup, const core::LaparoscopyCues& cues) {
    if (const auto* tube = std::get_if<simulation::ElasticTubeParameters>(&setup.parameters)) {
        const bool band = tube->task == simulation::TubeTask::hold || tube->task == simulation::TubeTask::twoHanded;
        GaugeDial dial;
        dial.title = Words::tr("Tension (N)");
        dial.range_N = endOfScale_N(band ? 1.5 * (tube->targetHigh_N + tube->band_N) : tube->maximumForce_N);
        dial.bandLow_N = cues.bandLow_N;
        dial.bandHigh_N = cues.bandHigh_N;
        return dial;
    }
    if (const auto* handling = std::get_if<simulation::ObjectHandlingParameters>(&setup.parameters)) {
        GaugeDial dial;
        dial.title = Words::tr("Squeeze (N)");
        dial.limit_N = cues.squeezeLimit_N;
        dial.range_N = endOfScale_N(1.5 * handling->squeezeLimit_N);
        return dial;
    }
    return std::nullopt;
}

bool dialShown(const core::LaparoscopyCues& cues) {
    return cues.present && (cues.tensionShown || cues.squeezeShown);
}

double dialValue_N(const core::LaparoscopyCues& cues) {
    return cues.tensionShown ? cues.tension_N : *std::max_element(cues.squeeze_N.begin(), cues.squeeze_N.end());
}

} // namespace chiron::scene3d
