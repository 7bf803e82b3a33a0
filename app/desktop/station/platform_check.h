// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "desktop/frame/background.h"
#include "mechanisms/fingertip_verification.h"

#include <vector>

namespace chiron::desktop {

/// P3's verification of the simulated fingertip platform, and what goes with it.
struct PlatformCheck {
    mechanisms::FingertipPlatformParameters plant;
    std::string serialNumber; ///< DeviceDescriptor::serialNumber of what was checked; a simulated platform tells none
    mechanisms::FingertipVerification verified;
    std::vector<mechanisms::FingertipOnFinger> fingers; ///< the same on seven others
    mechanisms::FingertipFriction friction;
    double stiffnessCap_N_per_m = 0.0; ///< with the damping of drives and pad at the measured delay
    bool holds() const noexcept { return verified.holds() && mechanisms::holdsOnAll(fingers); }
    std::vector<mechanisms::FingertipDegradation> worse; ///< one thing of the plant made worse at a time
};

/// How long: the number of cycles is P3's, the rest can be less where a test has no time.
struct PlatformCheckLength {
    int poses = 100;
    bool degrade = true;
    std::uint64_t seed = 1;
};

/// Blocking: a worker's task, some seconds; ends early, with cancelled, between its steps. Failure: the verification's.
core::Result<PlatformCheck> runPlatformCheck(const PlatformCheckLength& length, WorkToken& token);

} // namespace chiron::desktop
