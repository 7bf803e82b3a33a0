// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/station/platform_check.h"

#include "core/units.h"

#include <algorithm>

namespace chiron::desktop {

core::Result<PlatformCheck> runPlatformCheck(const PlatformCheckLength& length, WorkToken& token) {
    constexpr int kSteps = 4;
    const auto stopped = [] { return core::fail(core::ErrorCode::cancelled, "stopped by the person"); };
    PlatformCheck check;
    mechanisms::FingertipVerificationSettings settings;
    settings.poses = length.poses;
    token.setProgress(0, kSteps);
    auto verified = mechanisms::verifyFingertip(check.plant, length.seed, settings);
    CHIRON_TRY(verified);
    check.verified = std::move(*verified);
    token.setProgress(1, kSteps);
    if (token.cancelled())
        return stopped();
    auto fingers = mechanisms::verifyFingertipOnFingers(check.plant, length.seed, settings);
    CHIRON_TRY(fingers);
    check.fingers = std::move(*fingers);
    token.setProgress(2, kSteps);
    if (token.cancelled())
        return stopped();
    check.friction = mechanisms::identifyFingertipFriction(check.plant);
    check.stiffnessCap_N_per_m =
        mechanisms::stiffnessCap_N_per_m(mechanisms::fingertipDamping_Ns_per_m(check.friction, check.plant),
                                         core::kTickSeconds, check.verified.latency_s);
    token.setProgress(3, kSteps);
    if (token.cancelled())
        return stopped();
    if (!length.degrade)
        return check;
    // Poses for each of twenty degraded plants: enough to see the effect, within some seconds.
    constexpr int kPosesEach = 20;
    settings.poses = std::min(settings.poses, kPosesEach);
    auto worse = mechanisms::degradeFingertip(check.plant, length.seed, settings);
    CHIRON_TRY(worse);
    check.worse = std::move(*worse);
    if (token.cancelled())
        return stopped();
    return check;
}

} // namespace chiron::desktop
