// SPDX-License-Identifier: GPL-3.0-or-later
// Makes participants. This allocates, so it is kept apart from the code of the tick.
#include "operators/comparison/comparison_explorer.h"

#include <cmath>

namespace chiron::operators {

ComparisonBriefing comparisonBriefing(const simulation::ComparisonParameters& p) noexcept {
    ComparisonBriefing briefing;
    briefing.attribute = p.attribute;
    briefing.places = p.places;
    for (int place = 0; place < 3; ++place)
        briefing.x_m[static_cast<std::size_t>(place)] = simulation::placeX_m(p, place);
    briefing.height_m = p.hookHeight_m;
    briefing.usualStiffness_N_per_m =
        p.attribute == simulation::ComparedAttribute::stiffness && !p.values.empty()
            ? p.values.front()[0]
            : p.object.stiffness_N_per_m;
    briefing.padRadius_m = p.padRadius_m;
    briefing.probe_N = p.probeAtLeast_N;
    briefing.share = p.object.recoveryShare;
    return briefing;
}

mechanisms::HandParameters comparisonHand() noexcept {
    mechanisms::HandParameters hand = mechanisms::HandParameters::firm();
    hand.tremorRms_m = 0.05e-3;
    return hand;
}

ComparisonExplorer::ComparisonExplorer(const ComparisonBriefing& briefing,
                                       const mechanisms::HandParameters& hand) noexcept
    : m_briefing(briefing), m_grip_N_per_m(hand.gripStiffness_N_per_m), m_arm_N_per_m(hand.stiffness_N_per_m),
      m_reaction_s(hand.reactionDelay_s), m_instrument(hand) {}

ComparisonExplorer::~ComparisonExplorer() = default;

core::Result<std::unique_ptr<ComparisonExplorer>> makeComparisonExplorer(const ComparisonBriefing& briefing) {
    if (briefing.places < 1 || briefing.places > 3 || !(briefing.usualStiffness_N_per_m > 0.0))
        return core::fail(core::ErrorCode::badInput,
                          "participant: 1 to 3 places and a usual stiffness above 0 are expected");
    return std::make_unique<ComparisonExplorer>(briefing, comparisonHand());
}

} // namespace chiron::operators
