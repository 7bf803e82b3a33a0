// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/object_reader.h"
#include "simulation/yield.h"

#include <array>
#include <cmath>

namespace chiron::catalogue {

/// The keys with which a level says when the touched tissue gives way. If they are left out, or the force is
/// 0, it never gives way, as in sessions recorded before there was such a law.
inline constexpr std::array<const char*, 2> kYieldKeys{"yield_force_N", "yield_fall_ms"};
/// The same for a torque, in exercises that turn the tool back.
inline constexpr const char* kYieldTorqueKey = "yield_torque_mN_m";
/// Tissue gives way at this multiple of the largest allowed force or torque at the latest.
inline constexpr double kLatestYield = 3.0;

inline void readYield(const ObjectReader& parameters, simulation::YieldLaw& law) {
    if (parameters.has(QLatin1String(kYieldKeys[0])))
        if (const double force_N = parameters.number(QLatin1String(kYieldKeys[0])); force_N > 0.0)
            law.force_N = force_N;
    if (parameters.has(QLatin1String(kYieldKeys[1])))
        law.fall_s = parameters.number(QLatin1String(kYieldKeys[1])) / 1000.0;
    if (parameters.has(QLatin1String(kYieldTorqueKey)))
        if (const double torque_mNm = parameters.number(QLatin1String(kYieldTorqueKey)); torque_mNm > 0.0)
            law.torque_Nm = torque_mNm / 1000.0;
}

/// Checks that tissue gives way only above the largest allowed force, and at kLatestYield times that force at
/// the latest.
inline void checkYield(const simulation::YieldLaw& law, double limit_N, const QString& path,
                       Problems& problems) {
    if (!std::isfinite(law.force_N) || (law.force_N > limit_N && law.force_N <= kLatestYield * limit_N))
        return;
    problems.push_back({memberPath(path, kYieldKeys[0]), QString::number(law.force_N),
                        QStringLiteral("more than maximum_force_N = %1, and at most %2 times that")
                            .arg(limit_N)
                            .arg(kLatestYield)});
}

inline void checkYieldTorque(const simulation::YieldLaw& law, double limit_Nm, const QString& path,
                             Problems& problems) {
    if (!std::isfinite(law.torque_Nm) ||
        (law.torque_Nm > limit_Nm && law.torque_Nm <= kLatestYield * limit_Nm))
        return;
    problems.push_back({memberPath(path, kYieldTorqueKey), QString::number(1000.0 * law.torque_Nm),
                        QStringLiteral("more than maximum_torque_mN_m = %1, and at most %2 times that")
                            .arg(1000.0 * limit_Nm)
                            .arg(kLatestYield)});
}

} // namespace chiron::catalogue
