// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/laparoscopy_steps.h"

#include "cues/laparoscopy_cues.h"
#include "session/playback_track.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace chiron::session {

namespace {

/// The stored token of a step, as in PlaybackMark::detail; empty if it is not a step to be done.
std::string_view tokenOf(core::LaparoscopyStep step) {
    switch (step) {
    case core::LaparoscopyStep::grasp:
        return "grasp";
    case core::LaparoscopyStep::stretch:
        return "stretch";
    case core::LaparoscopyStep::hold:
        return "hold";
    case core::LaparoscopyStep::handOver:
        return "hand_over";
    case core::LaparoscopyStep::lift:
        return "lift";
    case core::LaparoscopyStep::carry:
        return "carry";
    case core::LaparoscopyStep::place:
        return "place";
    case core::LaparoscopyStep::retract:
        return "retract";
    case core::LaparoscopyStep::none:
    case core::LaparoscopyStep::done:
        break;
    }
    return {};
}

} // namespace

void nameSteps(PlaybackTrack& track) {
    const PlaybackQuantity* step = track.quantity("step");
    if (step == nullptr)
        return;
    for (PlaybackMark& mark : track.marks) {
        if (mark.kind != mark_kinds::kStageChanged)
            continue;
        const auto at = std::find_if(track.moments.begin(), track.moments.end(),
                                     [&](const PlaybackMoment& moment) { return moment.tick >= mark.tick; });
        if (at != track.moments.end())
            mark.detail = tokenOf(static_cast<core::LaparoscopyStep>(
                std::lround(step->values[static_cast<std::size_t>(at - track.moments.begin())])));
    }
}

} // namespace chiron::session
