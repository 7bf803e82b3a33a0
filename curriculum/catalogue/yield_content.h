// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/parameter_rows.h"
#include "simulation/yield.h"

#include <cmath>

namespace chiron::catalogue {

/// The keys with which a level says when the touched tissue gives way. If they are left out, or the force is
/// 0, it never gives way, as in sessions recorded before there was such a law.
inline constexpr const char* kYieldForceKey = "yield_force_N";
inline constexpr const char* kYieldFallKey = "yield_fall_ms";
/// The same for a torque, in exercises that turn the tool back.
inline constexpr const char* kYieldTorqueKey = "yield_torque_mN_m";
/// Tissue gives way at this multiple of the largest allowed force or torque at the latest.
inline constexpr double kLatestYield = 3.0;

/// Return the rows of a struct that has its law in `yield`. `most_N` is kLatestYield times the largest force
/// that a level may allow.
template <class P>
ParameterRow<P> yieldForceRow(double most_N = 30.0,
                              const char* description =
                                  "What is touched gives way beyond this force: a critical error. More than "
                                  "maximum_force_N and at most three times that; 0: never.") {
    return ParameterRow<P>::limit(kYieldForceKey, units::kN, most_N,
                                  within(&P::yield, &simulation::YieldLaw::force_N), description);
}
template <class P>
ParameterRow<P> yieldFallRow(const char* description = "How long the force takes to fall to nothing then.") {
    return ParameterRow<P>::number(kYieldFallKey, units::kMs, {5, 500},
                                   within(&P::yield, &simulation::YieldLaw::fall_s), description);
}
template <class P> ParameterRow<P> yieldTorqueRow(double most_mNm, const char* description) {
    return ParameterRow<P>::limit(kYieldTorqueKey, units::kMilliNm, most_mNm,
                                  within(&P::yield, &simulation::YieldLaw::torque_Nm), description);
}

/// Checks that tissue gives way only above the largest allowed force, and at kLatestYield times that force at
/// the latest.
inline void checkYield(const simulation::YieldLaw& law, double limit_N, const QString& path,
                       Problems& problems) {
    if (!std::isfinite(law.force_N) || (law.force_N > limit_N && law.force_N <= kLatestYield * limit_N))
        return;
    problems.push_back({memberPath(path, kYieldForceKey), QString::number(law.force_N),
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
