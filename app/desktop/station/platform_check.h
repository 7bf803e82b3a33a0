// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "desktop/frame/background.h"
#include "mechanisms/fingertip_verification.h"

#include <vector>

namespace chiron::desktop {

/// P3's verification of the simulated fingertip platform, with its additional measurements.
struct PlatformCheck {
    mechanisms::FingertipPlatformParameters plant;
    /// DeviceDescriptor::serialNumber of the checked device; empty for a simulated platform.
    std::string serialNumber;
    mechanisms::FingertipVerification verified;
    std::vector<mechanisms::FingertipOnFinger> fingers; ///< the same check on seven other fingers
    mechanisms::FingertipFriction friction;
    double stiffnessCap_N_per_m = 0.0; ///< from the damping of drives and pad at the measured delay
    bool holds() const noexcept { return verified.holds() && mechanisms::holdsOnAll(fingers); }
    /// With one property of the plant degraded at a time.
    std::vector<mechanisms::FingertipDegradation> worse;
};

/// The length of a check. The number of cycles is P3's; the rest may be less if a test is short of time.
struct PlatformCheckLength {
    int poses = 100;
    bool degrade = true;
    std::uint64_t seed = 1;
};

/// Runs the check, which takes some seconds. Cancelling takes effect between its steps.
/// Thread: worker; blocks.
/// Errors: those of the verification; cancelled.
core::Result<PlatformCheck> runPlatformCheck(const PlatformCheckLength& length, WorkToken& token);

} // namespace chiron::desktop
