// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "unit/haptics/safety_rig.h"

#include <vector>

namespace chiron::test {

/// One to four tools; the first renders force at 1 kHz, the others may be slow or input-only.
inline std::vector<devices::DeviceDescriptor> randomDevices(core::Random& random) {
    std::vector<devices::DeviceDescriptor> devices;
    const std::uint64_t tools = 1 + random.below(4);
    for (std::uint64_t i = 0; i < tools; ++i) {
        auto device = sixAxisDevice(random.uniform(0.5, 6.0), random.uniform(0.02, 0.2));
        device.maximumForce_N = random.uniform(0.5, 8.0);
        device.maximumTorque_Nm = random.uniform(0.02, 0.3);
        device.rendersForce = i == 0 || random.uniform() >= 0.2;
        device.period_us =
            random.uniform() < 0.1 ? 4001 : static_cast<std::uint32_t>(1000 * (1 + random.below(4)));
        device.maximumDamping_Ns_per_m = random.uniform(5.0, 50.0);
        devices.push_back(device);
    }
    devices[0].period_us = 1000;
    return devices;
}

/// The defaults, often with shorter ramps and always with another exercise cap.
inline haptics::SafetySettings randomSettings(core::Random& random) {
    haptics::SafetySettings settings;
    if (random.uniform() < 0.7) { // shorter ramps: more transitions in the same time
        settings.armingRamp_ms = static_cast<std::uint32_t>(20 + random.below(100));
        settings.stillTime_ms = static_cast<std::uint32_t>(5 + random.below(50));
        settings.pauseRamp_ms = static_cast<std::uint32_t>(10 + random.below(50));
        settings.heartbeatRamp_ms = settings.pauseRamp_ms;
    }
    settings.exerciseForce_N = random.uniform(0.5, 6.0);
    return settings;
}

} // namespace chiron::test
