// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "mechanisms/fingertip_platform_parameters.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace chiron::mechanisms {

/// What P3 published (its table 1, §3.2, abstract).
struct FingertipPublished {
    static constexpr std::array<double, 3> kRmse_N{0.073, 0.068, 0.071};
    static constexpr double kMeanRmse_N = 0.0707;
    static constexpr double kMeanError_deg = 1.95;
    static constexpr double kSdError_deg = 1.5;
};

/// How it is verified. P3 prints the peak and the number of cycles, neither the sine's frequency nor N_s: both ASSUMPTIONS.
struct FingertipVerificationSettings {
    double frequency_Hz = 0.5;   ///< 0.05..5
    double peak_N = 1.0;         ///< P3; > 0, ≤ 4
    int poses = 100;             ///< N_s, 1..10000
    double settle_s = 0.6;       ///< from the command of a pose to its reading, 0.1..5
};

/// One tick of the sine, or one pose: what was wanted, what the device's own sensors say, what was really so.
struct FingertipSeries {
    std::vector<double> time_s, reference_N, measured_N, true_N, height_m;
};
struct FingertipPosed {
    double referencePitch_rad = 0.0, referenceRoll_rad = 0.0;
    double measuredPitch_rad = 0.0, measuredRoll_rad = 0.0; ///< by the IMU, as P3 measured
    double truePitch_rad = 0.0, trueRoll_rad = 0.0;
};

struct FingertipVerification {
    FingertipVerificationSettings settings;
    std::array<double, 3> rmse_N{};     ///< of each cycle, by the force sensors (as P3)
    std::array<double, 3> rmseTrue_N{}; ///< of each cycle, of what the pad really got
    double meanRmse_N = 0.0, meanRmseTrue_N = 0.0;
    double meanError_deg = 0.0, sdError_deg = 0.0;         ///< eq. 4 by the IMU (as P3), with N_s terms
    double meanErrorTrue_deg = 0.0, sdErrorTrue_deg = 0.0; ///< of where the platform really was
    double latency_s = 0.0;  ///< from a step of 0.5 N on 1 N to a tenth of it on the pad
    FingertipSeries series;
    std::vector<FingertipPosed> poses;
    /// Better than both of P3's figures, as it measured them.
    bool holds() const noexcept {
        return meanRmse_N < FingertipPublished::kMeanRmse_N && meanError_deg < FingertipPublished::kMeanError_deg;
    }
};

/// P3 §3 on the simulated platform: three cycles of r_f = ½ peak (1 − cos 2πft) from a platform that stands off the pad, RMSE
/// of each cycle and their mean; then N_s random orientations within ±30°, ±20°, nothing pressed,
///   e_p = 1/N_s Σ √((α_ref − α_m)² + (β_ref − β_m)²)
/// with N_s terms (P3's sum runs from 0 to N_s, one too many). The same seed gives the same bits. Allocates; not in the tick.
/// Failure: badInput for settings out of range.
core::Result<FingertipVerification> verifyFingertip(const FingertipPlatformParameters& parameters, std::uint64_t seed,
                                                    const FingertipVerificationSettings& settings = {});

/// What the figures do when one thing of the plant gets worse: factors 0, 1, 2, 4 (of the converter: 16 bits, 10, 9, 8).
struct FingertipDegradation {
    std::string what; ///< "force_noise", "adc", "delay", "friction", "backlash", "imu"
    double factor = 1.0;
    double rmse_N = 0.0, rmseTrue_N = 0.0, meanError_deg = 0.0, meanErrorTrue_deg = 0.0;
    bool holds = false;
};
core::Result<std::vector<FingertipDegradation>> degradeFingertip(const FingertipPlatformParameters& parameters, std::uint64_t seed,
                                                                 const FingertipVerificationSettings& settings = {});

/// What friction of one drive is by moving all three together slowly, off the pad, at two speeds there and back (Tholey's
/// method, as friction_identification.h): N, N·s/m, of the motor forces asked.
struct FingertipFriction {
    double coulomb_N = 0.0;
    double viscous_Ns_per_m = 0.0;
};
FingertipFriction identifyFingertipFriction(const FingertipPlatformParameters& parameters);

/// b + B of a finger pressing: three drives, as identified, and the pad (N·s/m). The default of the stiffness cap, on the command line and
/// on the station's screen alike.
constexpr double fingertipDamping_Ns_per_m(const FingertipFriction& friction, const FingertipPlatformParameters& parameters) noexcept {
    return 3.0 * friction.viscous_Ns_per_m + parameters.pad.damping_Ns_per_m;
}

/// The stiffest wall that a device with this damping and loop delay renders stably: K < (b + B)/(T/2 + t_d), N/m
/// (devices.md §6, delay). `damping`: b of device and hand plus B of the wall, N·s/m.
constexpr double stiffnessCap_N_per_m(double damping_Ns_per_m, double period_s, double delay_s) noexcept {
    return damping_Ns_per_m / (0.5 * period_s + delay_s);
}

} // namespace chiron::mechanisms
