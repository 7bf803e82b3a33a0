// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "mechanisms/fingertip_platform_parameters.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace chiron::mechanisms {

/// The results that P3 published (its table 1, §3.2, abstract).
struct FingertipPublished {
    static constexpr std::array<double, 3> kRmse_N{0.073, 0.068, 0.071};
    static constexpr double kMeanRmse_N = 0.0707;
    static constexpr double kMeanError_deg = 1.95;
    static constexpr double kSdError_deg = 1.5;
};

/// Settings of the verification. P3 prints the peak and the number of cycles, but neither the sine's
/// frequency nor N_s: both are ASSUMPTIONS.
struct FingertipVerificationSettings {
    double frequency_Hz = 0.5; ///< 0.05..5
    double peak_N = 1.0;       ///< P3; > 0, ≤ 4
    int poses = 100;           ///< N_s, 1..10000
    double settle_s = 0.6;     ///< from a pose's command to its reading, 0.1..5
    /// Amplitude of the finger's movement in its holder, at 0.3 Hz while the sine runs, caused by muscles and
    /// pulse; 0..0.001 m. ASSUMPTION.
    double fingerMoves_m = 0.00015;
    bool feedback = true; ///< false: the force loop is cut, and the verification has to notice it
};

/// Bounds that the platform has to meet on every finger, judged by the true force on the pad.
struct FingertipBounds {
    static constexpr double kLimit_N = 4.0; ///< P3's largest force, at the pad
    /// Overshoot beyond the requested force, or beyond the settled one if that is larger, as a share of that
    /// force. A person notices the Weber fraction of force, 7 to 10 % (Jones, Matching forces: constant
    /// errors and differential thresholds, Perception 18, 1989).
    static constexpr double kOvershootOfForce = 0.10;
};

/// One tick of the sine, or one pose: the reference, the readings of the device's own sensors, and the true
/// values.
struct FingertipSeries {
    std::vector<double> time_s, reference_N, measured_N, true_N, height_m;
};
struct FingertipPosed {
    double referencePitch_rad = 0.0, referenceRoll_rad = 0.0;
    double measuredPitch_rad = 0.0, measuredRoll_rad = 0.0; ///< from the IMU, as P3 measured
    double truePitch_rad = 0.0, trueRoll_rad = 0.0;
};

struct FingertipVerification {
    FingertipVerificationSettings settings;
    FingerPadParameters pad;            ///< the real finger
    FingerPadParameters identified;     ///< the finger as the platform identified it with its own sensors
    std::array<double, 3> rmse_N{};     ///< per cycle, from the force sensors (as P3)
    std::array<double, 3> rmseTrue_N{}; ///< per cycle, from the true force on the pad
    double meanRmse_N = 0.0, meanRmseTrue_N = 0.0;
    double gain = 0.0, phase_deg = 0.0; ///< of the true force's first harmonic over the reference's; a lag is
                                        ///< negative
    double meanError_deg = 0.0, sdError_deg = 0.0;         ///< eq. 4 from the IMU (as P3), with N_s terms
    double meanErrorTrue_deg = 0.0, sdErrorTrue_deg = 0.0; ///< the same from the platform's true pose
    /// Largest overshoot of the true force in steps of 0 to 1, 1 to 1.5 and 2 to 3 N, three each: beyond the
    /// requested force, or beyond the settled one if that is larger, as a share of the step and of the force.
    double overshoot = 0.0, overshootOfForce = 0.0;
    /// Largest relative error, in these steps, of the true settled force against the requested one.
    double staticError = 0.0;
    double oneNewton_N = 0.0; ///< largest force on the pad in the steps from 0 to 1 N
    /// Largest force on the pad in all of the checks, mean over a tick: 4 N at once, from 2 N, leaning, and
    /// as a sine.
    double largest_N = 0.0;
    /// From a step of 0.5 N, starting at 1 N, to a tenth of that step on the pad.
    double latency_s = 0.0;
    FingertipSeries series;
    std::vector<FingertipPosed> poses;
    /// True if both of P3's figures are bettered, by the device's own sensors (as P3 measured) and by the
    /// true values, within FingertipBounds.
    bool holds() const noexcept {
        return meanRmse_N < FingertipPublished::kMeanRmse_N &&
               meanError_deg < FingertipPublished::kMeanError_deg &&
               meanRmseTrue_N < FingertipPublished::kMeanRmse_N &&
               meanErrorTrue_deg < FingertipPublished::kMeanError_deg &&
               overshootOfForce <= FingertipBounds::kOvershootOfForce &&
               largest_N <= FingertipBounds::kLimit_N;
    }
};

/// Repeats P3 §3 on the simulated platform, on the finger `parameters.pad`, after the platform has identified
/// it (identifyPad). First come three cycles of r_f = ½ peak (1 − cos 2πft) from a platform that stands off
/// the pad, with the RMSE of each cycle and their mean, while the finger moves in its holder. Then come N_s
/// random orientations within ±30°, ±20°, with no force requested:
///   e_p = 1/N_s Σ √((α_ref − α_m)² + (β_ref − β_m)²)
/// with N_s terms (P3's sum runs from 0 to N_s, one too many). Steps and the largest requests follow. The
/// same seed gives the same bits. Allocates; not for the tick.
/// Errors: badInput for settings out of range, or if no finger is found.
core::Result<FingertipVerification> verifyFingertip(const FingertipPlatformParameters& parameters,
                                                    std::uint64_t seed,
                                                    const FingertipVerificationSettings& settings = {});

/// Seven fingers other than `assumed`: half and twice the stiffness, a thick and a thin finger (softer and
/// harder with depth, lying lower and higher), one whose force relaxes by 40 %, and two that combine several
/// of these.
struct FingertipFinger {
    std::string finger; ///< "half", "double", "thick", "thin", "relaxing", "softest", "stiffest"
    FingerPadParameters pad;
};
std::vector<FingertipFinger> otherFingers(const FingerPadParameters& assumed);

/// Result of verifyFingertip on a finger other than the one that the controller starts with.
struct FingertipOnFinger {
    std::string finger; ///< as FingertipFinger
    FingertipVerification verified;
};
core::Result<std::vector<FingertipOnFinger>>
verifyFingertipOnFingers(const FingertipPlatformParameters& parameters, std::uint64_t seed,
                         const FingertipVerificationSettings& settings = {});
bool holdsOnAll(const std::vector<FingertipOnFinger>& fingers) noexcept; ///< false if there are none

/// How the results change when one property of the plant gets worse by the factors 0, 1, 2, 4 (for the
/// converter: 16 bits, 10, 9, 8).
struct FingertipDegradation {
    std::string what; ///< "force_noise", "adc", "delay", "friction", "backlash", "imu"
    double factor = 1.0;
    double rmse_N = 0.0, rmseTrue_N = 0.0, meanError_deg = 0.0, meanErrorTrue_deg = 0.0;
    double largest_N = 0.0; ///< as FingertipVerification
    bool holds = false;
};
core::Result<std::vector<FingertipDegradation>>
degradeFingertip(const FingertipPlatformParameters& parameters, std::uint64_t seed,
                 const FingertipVerificationSettings& settings = {});

/// Friction of one drive, identified by moving all three together slowly, off the pad, at two speeds in both
/// directions (Tholey's method, as in friction_identification.h): N, N·s/m, from the requested motor forces.
struct FingertipFriction {
    double coulomb_N = 0.0;
    double viscous_Ns_per_m = 0.0;
};
FingertipFriction identifyFingertipFriction(const FingertipPlatformParameters& parameters);

/// Returns b + B while a finger presses: three drives with the identified friction, and the pad (N·s/m). It
/// is the default for the stiffness cap, both on the command line and on the station's screen.
constexpr double fingertipDamping_Ns_per_m(const FingertipFriction& friction,
                                           const FingertipPlatformParameters& parameters) noexcept {
    return 3.0 * friction.viscous_Ns_per_m + parameters.pad.damping_Ns_per_m;
}

/// Returns the stiffness of the stiffest wall that a device with this damping and loop delay renders stably:
/// K < (b + B)/(T/2 + t_d), N/m (devices.md §6, delay). `damping`: b of device and hand plus B of the wall,
/// N·s/m.
constexpr double stiffnessCap_N_per_m(double damping_Ns_per_m, double period_s, double delay_s) noexcept {
    return damping_Ns_per_m / (0.5 * period_s + delay_s);
}

} // namespace chiron::mechanisms
