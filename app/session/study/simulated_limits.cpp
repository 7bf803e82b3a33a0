// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/simulated_limits.h"

#include "devices/drivers/simulated/simulated_device.h"
#include "mechanisms/scripted_motion.h"
#include "modules/exercises/comparison/operators/comparison_explorer.h"
#include "session/delay_measurement.h"

namespace chiron::session {

core::Result<RenderingLimits> simulatedLimits() {
    devices::SimulatedDevice::Configuration configuration;
    configuration.hand = operators::comparisonHand();
    auto device = devices::SimulatedDevice::create(configuration, std::make_unique<mechanisms::ScriptedMotion>(configuration.start_D));
    if (!device)
        return tl::unexpected(device.error());
    const auto delay = measureDelay(**device, configuration.mapping);
    if (!delay)
        return tl::unexpected(delay.error());
    return limitsAt((*device)->descriptor(), delay->delay_s);
}

} // namespace chiron::session
