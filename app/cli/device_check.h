// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"
#include "mechanisms/fingertip_arm_verification.h"
#include "mechanisms/fingertip_verification.h"

#include <QJsonValue>
#include <QString>
#include <optional>
#include <string>
#include <vector>

namespace chiron::cli {

/// What `device check` found of P3's simulated mechanism: the platform under the finger, and the arm that carries it.
struct FingertipCheck {
    std::uint64_t seed = 1;
    std::string serialNumber; ///< DeviceDescriptor::serialNumber of what was checked; a simulated one tells none
    mechanisms::FingertipVerification verification;
    std::vector<mechanisms::FingertipOnFinger> fingers; ///< the same on seven others
    mechanisms::FingertipFriction friction;
    double damping_Ns_per_m = 0.0;  ///< b + B in the cap of the stiffness
    double stiffnessCap_N_per_m = 0.0;
    std::vector<mechanisms::FingertipDegradation> degradation; ///< empty unless asked for
    mechanisms::FingertipArmVerification arm;
};

/// Holds on the finger that is assumed and on the seven others, and the arm does.
bool holds(const FingertipCheck& check) noexcept;

/// A device's serial number: null, or in words that it does not tell one.
QJsonValue serialJson(const std::string& serialNumber);
QString serialWords(const std::string& serialNumber);

/// As JSON and as a table beside P3's figures; exit 1 where the check does not hold.
CommandOutput describeFingertipCheck(const FingertipCheck& check, bool withSeries);

} // namespace chiron::cli
