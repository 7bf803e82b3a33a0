// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command_spec.h"
#include "mechanisms/fingertip_arm_verification.h"
#include "mechanisms/fingertip_verification.h"

#include <QJsonValue>
#include <QString>
#include <optional>
#include <string>
#include <vector>

namespace chiron::cli {

/// The results of `device check` for P3's simulated mechanism: the platform under the finger, and the arm
/// that carries it.
struct FingertipCheck {
    std::uint64_t seed = 1;
    std::string serialNumber; ///< DeviceDescriptor::serialNumber of the checked device; empty for a simulated
                              ///< one
    mechanisms::FingertipVerification verification;
    std::vector<mechanisms::FingertipOnFinger> fingers; ///< the same checks on seven other fingers
    mechanisms::FingertipFriction friction;
    double damping_Ns_per_m = 0.0; ///< b + B in the formula of the stiffness cap
    double stiffnessCap_N_per_m = 0.0;
    std::vector<mechanisms::FingertipDegradation> degradation; ///< empty unless asked for
    mechanisms::FingertipArmVerification arm;
};

/// True if the check holds on the assumed finger and on the seven others, and for the arm.
bool holds(const FingertipCheck& check) noexcept;

/// A device's serial number as JSON (null if the device does not report one) and as text (which then says
/// so).
QJsonValue serialJson(const std::string& serialNumber);
QString serialWords(const std::string& serialNumber);

/// The check as JSON and as a table beside P3's figures; the exit code is 1 if the check fails.
CommandOutput describeFingertipCheck(const FingertipCheck& check, bool withSeries);

} // namespace chiron::cli
