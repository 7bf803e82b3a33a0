// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The program uses SI units internally (m, s, N, N·m, rad, kg); millimetres and degrees appear only where a
/// person or a file reads them.
namespace chiron::core {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kStandardGravity = 9.80665; ///< m/s², ISO 80000-3 (conventional value)
inline constexpr double kTickSeconds = 0.001;       ///< the model step per executed tick (architecture.md)

constexpr double mmFromM(double m) {
    return m * 1e3;
}
constexpr double mFromMm(double mm) {
    return mm * 1e-3;
}
constexpr double degFromRad(double rad) {
    return rad * (180.0 / kPi);
}
constexpr double radFromDeg(double deg) {
    return deg * (kPi / 180.0);
}

} // namespace chiron::core
