// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/simulated_limits.h"

#include "mechanisms/scripted_motion.h"
#include "operators/comparison/comparison_explorer.h"
#include "session/delay_measurement.h"
#include "session/exercise_kind.h"
#include "session/station.h"

namespace chiron::session {

core::Result<RenderingLimits> simulatedLimits() {
    SimulatedHand atRest;
    atRest.strategy = std::make_unique<mechanisms::ScriptedMotion>(devices::kHeldFrom_D);
    atRest.hand = operators::comparisonHand();
    auto station = simulatedStation(kUsualMechanism, std::move(atRest));
    CHIRON_TRY(station);
    const StationTool& tool = station->tools.front();
    const auto delay = measureDelay(*tool.device, tool.mapping);
    CHIRON_TRY(delay);
    return limitsAt(tool.device->descriptor(), delay->delay_s);
}

} // namespace chiron::session
