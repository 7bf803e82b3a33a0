// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mechanisms/fingertip_arm_parameters.h"

#include <cstdint>
#include <vector>

namespace chiron::mechanisms {

/// What P3 says of the console's arm (§2.2, abstract); it prints no length, mass, friction or error of it.
struct FingertipArmPublished {
    static constexpr int kFreedoms = 7; ///< sensed
    static constexpr int kWrist = 3;    ///< by an IMU
    static constexpr int kPlace = 3;    ///< by three absolute magnetic encoders
    static constexpr int kGrasp = 1;    ///< by a Hall sensor
};

/// How finely it is looked at.
struct FingertipArmVerificationSettings {
    int grid = 8; ///< steps along each edge of the box, > 0
    std::vector<double> speeds_m_per_s{0.02, 0.05, 0.20}; ///< that the pad is led at, each > 0
};

/// What the arm has to meet. P3 gives no numbers, so each has its reason beside it.
struct FingertipArmBounds {
    static constexpr double kCondition = 5.0;     ///< of ∂p/∂q over the box: no direction asks five times as much of the encoders as another
    static constexpr double kInverse_m = 1e-9;    ///< closed form, there and back: rounding
    static constexpr double kInverse_rad = 1e-6;  ///< likewise
    static constexpr double kJacobian = 1e-6;     ///< against central differences of 1 µrad, whose own error it is, m/rad and rad/rad
    static constexpr double kGravity_Nm = 1e-6;   ///< against the potential's central differences, likewise
    static constexpr double kWeight_N = 0.06;     ///< on the hand: no more than the joints' dry friction holds at the pad
    static constexpr double kSinks_m = 3e-3;      ///< in half a second without a hand
    static constexpr double kFriction = 0.05;     ///< of what was given, as for the gimbal (friction_identification.h)
    static constexpr double kCount_m = 15e-6;     ///< of an encoder, at the pad: with 14 bits, 0.13 mm, contact shakes (tests/damping/README.md)
    static constexpr double kPlace_m = 0.5e-3;    ///< the pad beside where its encoders say
};

/// What a hand feels of the arm as it leads the pad along an axis of D at an even speed, its attitude held; mean of both ways, so that weight
/// is not in it.
struct FingertipArmDrag {
    int axis = 0; ///< 0 x, 1 y, 2 z
    double speed_m_per_s = 0.0;
    double felt_N = 0.0;
    double given_N = 0.0; ///< by power: (Σ τ_c |q̇| + b q̇²) / v of the joints' Coulomb and viscous friction
};

struct FingertipArmVerification {
    int poses = 0;   ///< a grid over the box, six attitudes each
    int reached = 0; ///< of them, with joints within their travel
    double condition = 0.0;    ///< worst of ∂p/∂q
    double inverse_m = 0.0, inverse_rad = 0.0; ///< worst, there and back
    double jacobian = 0.0;     ///< worst entry beside central differences, m/rad and rad/rad
    double gravity_Nm = 0.0;   ///< worst joint beside −∂V/∂q by central differences
    double weight_N = 0.0;     ///< the most that the hand carries at the pad
    double sinks_m = 0.0;      ///< the most in half a second, let go of at rest
    double massLeast_kg = 0.0, massMost_kg = 0.0; ///< that a hand moves along
    std::vector<FingertipArmDrag> drags;          ///< through the middle of the box
    int encoderBits = 0;
    double countLeast_m = 0.0, countMost_m = 0.0; ///< one count of an encoder, at the pad
    double place_m = 0.0;      ///< the most by which the pad is beside where the encoders say, noise and run-out included

    double frictionError() const noexcept; ///< largest |felt − given| / given
    bool holds() const noexcept;
};

/// P3's arm by its own kinematics, dynamics and sensors over the box that sessions use. `seed`: of the run-out and noise of the encoders. The same
/// seed gives the same bits. Allocates; not in the tick.
FingertipArmVerification verifyFingertipArm(const FingertipArmParameters& parameters, std::uint64_t seed,
                                            const FingertipArmVerificationSettings& settings = {});

} // namespace chiron::mechanisms
