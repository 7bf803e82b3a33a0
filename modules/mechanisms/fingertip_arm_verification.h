// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "mechanisms/fingertip_arm_parameters.h"

#include <cstdint>
#include <vector>

namespace chiron::mechanisms {

/// P3's statements about the console's arm (§2.2, abstract). P3 prints no length, mass, friction or error of
/// it.
struct FingertipArmPublished {
    static constexpr int kFreedoms = 7; ///< sensed
    static constexpr int kWrist = 3;    ///< by an IMU
    static constexpr int kPlace = 3;    ///< by three absolute magnetic encoders
    static constexpr int kGrasp = 1;    ///< by a Hall sensor
};

/// How finely the arm is checked.
struct FingertipArmVerificationSettings {
    int grid = 8; ///< steps along each edge of the box, 1..50
    /// Speeds at which the pad is moved: at least one, each 0.005..1.
    std::vector<double> speeds_m_per_s{0.02, 0.05, 0.20};
};

/// Requirements on the arm. P3 gives no numbers, so each bound has its reason beside it.
struct FingertipArmBounds {
    /// Condition number of ∂p/∂q over the box: no direction needs five times the encoder resolution of
    /// another.
    static constexpr double kCondition = 5.0;
    static constexpr double kInverse_m = 1e-9;   ///< closed form, forward and back: rounding
    static constexpr double kInverse_rad = 1e-6; ///< likewise
    /// Against central differences of 1 µrad, whose own error this is, m/rad and rad/rad.
    static constexpr double kJacobian = 1e-6;
    static constexpr double kGravity_Nm = 1e-6; ///< against central differences of the potential, likewise
    static constexpr double kWeight_N = 0.06;   ///< force on the hand: no more than the joints' dry
                                                ///< friction holds at the pad
    static constexpr double kSinks_m = 3e-3;    ///< in half a second without a hand
    static constexpr double kFriction = 0.05;   ///< relative error against the given friction, as for the
                                                ///< gimbal (friction_identification.h)
    /// Largest count of an encoder at the pad. With 14 bits it is 0.13 mm, and contact shakes
    /// (tests/damping/README.md).
    static constexpr double kCount_m = 15e-6;
    static constexpr double kPlace_m = 0.5e-3; ///< distance of the pad from the position that its encoders
                                               ///< report
};

/// The force that a hand feels as it moves the pad along an axis of D at constant speed with a fixed
/// attitude. It is the mean of both directions, so that the weight cancels.
struct FingertipArmDrag {
    int axis = 0; ///< 0 x, 1 y, 2 z
    double speed_m_per_s = 0.0;
    double felt_N = 0.0;
    double given_N = 0.0; ///< from power: (Σ τ_c |q̇| + b q̇²) / v of the joints' Coulomb and viscous
                          ///< friction
};

struct FingertipArmVerification {
    int poses = 0;                             ///< a grid over the box, with six attitudes at each point
    int reached = 0;                           ///< poses whose joints are within their travel
    double condition = 0.0;                    ///< largest condition number of ∂p/∂q
    double inverse_m = 0.0, inverse_rad = 0.0; ///< largest error, forward and back
    double jacobian = 0.0;   ///< largest error of an entry against central differences, m/rad and rad/rad
    double gravity_Nm = 0.0; ///< largest error of a joint against −∂V/∂q by central differences
    double weight_N = 0.0;   ///< largest weight that the hand carries at the pad
    double sinks_m = 0.0;    ///< largest distance that it sinks in half a second after release at rest
    double massLeast_kg = 0.0, massMost_kg = 0.0; ///< that a hand moves
    std::vector<FingertipArmDrag> drags;          ///< through the middle of the box
    int encoderBits = 0;
    double countLeast_m = 0.0, countMost_m = 0.0; ///< one count of an encoder, at the pad
    /// Largest distance of the pad from the position that the encoders report, noise and run-out included.
    double place_m = 0.0;

    /// Returns the largest |felt − given| / given; not a number if one is not.
    double frictionError() const noexcept;
    bool holds() const noexcept;
};

/// Verifies P3's arm with its own kinematics, dynamics and sensors over the box that sessions use. `seed` is
/// that of the encoders' run-out and noise. The same seed gives the same bits. Allocates; not for the tick.
/// Errors: badInput for settings out of range.
core::Result<FingertipArmVerification>
verifyFingertipArm(const FingertipArmParameters& parameters, std::uint64_t seed,
                   const FingertipArmVerificationSettings& settings = {});

} // namespace chiron::mechanisms
