// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/fingertip_arm_verification.h"

#include "mechanisms/fingertip_arm_plant.h"
#include "mechanisms/rotation_vector.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace chiron::mechanisms {

using core::Quat;
using core::Vec3;

namespace {

constexpr int kArmJoints = FingertipArmParameters::kJoints;
constexpr int kArmHandle = FingertipArmParameters::kHandle;
constexpr int kPoseJoints = 6; // the seventh is the lever
constexpr double kDifference_rad = 1e-6;

core::Result<void> checked(const FingertipArmVerificationSettings& s) {
    const auto refuse = [](const char* what) {
        return core::fail(core::ErrorCode::badInput, std::string("fingertip arm verification: ") + what);
    };
    if (!(s.grid >= 1 && s.grid <= 50))
        return refuse("1 to 50 steps along each edge of the box are expected");
    // The slower the pad, the longer it takes; at zero it would never arrive.
    if (s.speeds_m_per_s.empty() || !std::all_of(s.speeds_m_per_s.begin(), s.speeds_m_per_s.end(),
                                                 [](double v) { return v >= 0.005 && v <= 1.0; }))
        return refuse("at least one speed is expected, each 0.005 to 1 m/s");
    return {};
}

/// Visits corners, edges, faces and inside of the box that sessions use.
template <class Visit> void overTheBox(const FingertipArmParameters& p, int steps, Visit&& visit) {
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j)
            for (int k = 0; k <= steps; ++k) {
                const Vec3 share(static_cast<double>(i) / steps, static_cast<double>(j) / steps,
                                 static_cast<double>(k) / steps);
                visit(Vec3(p.boxMinimum_m + share.cwiseProduct(p.boxMaximum_m - p.boxMinimum_m)));
            }
}

/// Attitudes with the pad down, and leaned or turned as far as a hand does in palpation.
std::array<Vec3, 6> attitudes() {
    return {Vec3(0.0, 0.0, 0.0), Vec3(0.6, 0.0, 0.0),  Vec3(-0.6, 0.0, 0.0),
            Vec3(0.0, 0.6, 0.0), Vec3(0.0, -0.6, 0.0), Vec3(0.0, 0.0, 0.8)};
}

/// Central difference of the handle's position and attitude by one joint angle.
Eigen::Matrix<double, 6, 1> difference(FingertipArmDynamics& chain, const FingertipArmJoints& q, int joint) {
    FingertipArmJoints shifted = q;
    shifted[joint] = q[joint] + kDifference_rad;
    chain.place(shifted);
    const Vec3 p = chain.joint(kArmHandle);
    const Quat turn(chain.orientation(kArmHandle));
    shifted[joint] = q[joint] - kDifference_rad;
    chain.place(shifted);
    Eigen::Matrix<double, 6, 1> d;
    d.head<3>() = p - chain.joint(kArmHandle);
    d.tail<3>() = rotationVectorOf(turn * Quat(chain.orientation(kArmHandle)).conjugate());
    return d / (2.0 * kDifference_rad);
}

double potentialSlope(FingertipArmDynamics& chain, const FingertipArmJoints& q, int joint) {
    FingertipArmJoints shifted = q;
    shifted[joint] = q[joint] + kDifference_rad;
    chain.place(shifted);
    const double above = chain.potential_J();
    shifted[joint] = q[joint] - kDifference_rad;
    chain.place(shifted);
    return (above - chain.potential_J()) / (2.0 * kDifference_rad);
}

void checkPose(FingertipArmVerification& v, FingertipArmDynamics& chain, const FingertipArmParameters& p,
               const Vec3& at, const Quat& turn) {
    ++v.poses;
    const ArmPosture posture = fingertipArmPosture(p, at, turn);
    if (posture.reach != ArmReach::reached)
        return;
    ++v.reached;
    chain.place(posture.q);
    v.inverse_m = std::max(v.inverse_m, (chain.joint(kArmHandle) - at).norm());
    v.inverse_rad = std::max(v.inverse_rad,
                             rotationVectorOf(Quat(chain.orientation(kArmHandle)) * turn.conjugate()).norm());
    const FingertipArmDynamics::Jacobian jacobian = chain.jacobian(kArmHandle, chain.joint(kArmHandle));
    const FingertipArmJoints gravity = chain.gravity();
    for (int joint = 0; joint < kPoseJoints; ++joint)
        v.jacobian = std::max(
            v.jacobian, (jacobian.col(joint) - difference(chain, posture.q, joint)).cwiseAbs().maxCoeff());
    for (int joint = 0; joint < kArmJoints; ++joint)
        v.gravity_Nm =
            std::max(v.gravity_Nm, std::abs(gravity[joint] - potentialSlope(chain, posture.q, joint)));
    const core::Mat3 ofPlace = FingertipArmPlace(p.geometry).jacobian(posture.q.head<3>());
    v.condition = std::max(v.condition, FingertipArmPlace::conditionNumber(ofPlace));
    const Eigen::RowVector3d counts = p.encoderResolution_rad() * ofPlace.colwise().norm();
    v.countLeast_m = std::min(v.countLeast_m, counts.minCoeff());
    v.countMost_m = std::max(v.countMost_m, counts.maxCoeff());
}

/// Checks the arm at rest at a position: its weight on a hand, its sinking without one, the mass that a hand
/// moves, and the position that its encoders report.
void checkRest(FingertipArmVerification& v, const FingertipArmParameters& p, std::uint64_t seed,
               const Vec3& at) {
    FingertipArmPlant arm(p, seed);
    arm.reset(at);
    const FingertipArmPlace place(p.geometry);
    const auto counts = arm.encoderCounts();
    v.place_m = std::max(
        v.place_m,
        (place.place_D(p.encoderResolution_rad() * Vec3(counts[0], counts[1], counts[2])) - at).norm());
    const Vec3 left = (1.0 - p.counterbalance) * arm.dynamics().gravity().head<3>();
    const core::Mat3 j = place.jacobian(arm.q().head<3>());
    v.weight_N = std::max(v.weight_N, Vec3(j.transpose().inverse() * left).norm());
    v.massLeast_kg = std::min(v.massLeast_kg, arm.apparentMass_kg());
    v.massMost_kg = std::max(v.massMost_kg, arm.apparentMass_kg());
    const double dt_s = core::kTickSeconds / arm.parameters().substeps;
    for (double t_s = 0.0; t_s < 0.5; t_s += dt_s)
        arm.step(dt_s, {});
    v.sinks_m = std::max(v.sinks_m, (arm.motion().p_DT - at).norm());
}

/// Returns the force that the joints' friction takes from a hand at this velocity and posture.
double givenFriction_N(const FingertipArmPlant& arm, const Vec3& velocity) {
    const auto jacobian = arm.dynamics().jacobian(kArmHandle, arm.dynamics().joint(kArmHandle));
    Eigen::Matrix<double, 6, 1> wanted = Eigen::Matrix<double, 6, 1>::Zero(); // the attitude is fixed
    wanted.head<3>() = velocity;
    const Eigen::Matrix<double, 6, 6> ofPose = jacobian.leftCols<kPoseJoints>();
    const Eigen::Matrix<double, 6, 1> rates = ofPose.partialPivLu().solve(wanted);
    double power_W = 0.0;
    for (int joint = 0; joint < kPoseJoints; ++joint) {
        const LugreParameters& friction = arm.parameters().friction[static_cast<std::size_t>(joint)];
        power_W += friction.coulomb * std::abs(rates[joint]) + friction.viscous * rates[joint] * rates[joint];
    }
    return power_W / velocity.norm();
}

/// Moves through the middle in one direction by a stiff hand that holds the attitude. Returns the mean force
/// along the way and the mean of the given friction.
std::pair<double, double> drag(const FingertipArmParameters& p, int axis, double velocity_m_per_s) {
    constexpr double kHalfWay_m = 0.03, kJudged_m = 0.01; // start, and the part that runs at constant speed
    constexpr double kStiffness_N_per_m = 1000.0, kDamping_Ns_per_m = 30.0; // critical with 0.2 kg
    constexpr double kTurn_Nm_per_rad = 2.0, kTurnDamping_Nms_per_rad = 0.03;
    const Vec3 middle = 0.5 * (p.boxMinimum_m + p.boxMaximum_m);
    const Vec3 velocity = velocity_m_per_s * Vec3::Unit(axis), direction = velocity.normalized();
    FingertipArmPlant arm(p, 1);
    Vec3 target = middle - kHalfWay_m * direction;
    arm.reset(target);
    const double dt_s = core::kTickSeconds / arm.parameters().substeps;
    double felt = 0.0, given = 0.0;
    int counted = 0;
    for (;;) {
        target += dt_s * velocity;
        const double along = (target - middle).dot(direction);
        if (along > kJudged_m)
            break;
        const ToolMotion now = arm.motion();
        core::Wrench hand;
        hand.force = kStiffness_N_per_m * (target - now.p_DT) + kDamping_Ns_per_m * (velocity - now.v_DT);
        hand.torque = -kTurn_Nm_per_rad * rotationVectorOf(now.q_DT) - kTurnDamping_Nms_per_rad * now.w_DT;
        arm.step(dt_s, hand);
        if (along < -kJudged_m)
            continue;
        felt += hand.force.dot(direction);
        given += givenFriction_N(arm, velocity);
        ++counted;
    }
    return {felt / counted, given / counted};
}

} // namespace

double FingertipArmVerification::frictionError() const noexcept {
    double worst = 0.0;
    for (const FingertipArmDrag& one : drags) {
        const double error = std::abs(one.felt_N - one.given_N) / one.given_N;
        if (std::isnan(error))
            return error; // NaN is within no bound, and std::max would drop it
        worst = std::max(worst, error);
    }
    return worst;
}

bool FingertipArmVerification::holds() const noexcept {
    using Bounds = FingertipArmBounds;
    return poses > 0 && reached == poses && condition <= Bounds::kCondition &&
           inverse_m <= Bounds::kInverse_m && inverse_rad <= Bounds::kInverse_rad &&
           jacobian <= Bounds::kJacobian && gravity_Nm <= Bounds::kGravity_Nm &&
           weight_N <= Bounds::kWeight_N && sinks_m <= Bounds::kSinks_m && !drags.empty() &&
           frictionError() <= Bounds::kFriction && countMost_m <= Bounds::kCount_m &&
           place_m <= Bounds::kPlace_m;
}

core::Result<FingertipArmVerification> verifyFingertipArm(const FingertipArmParameters& parameters,
                                                          std::uint64_t seed,
                                                          const FingertipArmVerificationSettings& settings) {
    CHIRON_TRY(checked(settings));
    FingertipArmVerification v;
    v.encoderBits = parameters.encoderBits;
    v.countLeast_m = v.massLeast_kg = 1e9;
    FingertipArmDynamics chain(fingertipArmLinks(parameters));
    overTheBox(parameters, settings.grid, [&](const Vec3& at) {
        for (const Vec3& lean : attitudes())
            checkPose(v, chain, parameters, at, turned(Quat::Identity(), lean));
    });
    overTheBox(parameters, 2, [&](const Vec3& at) { checkRest(v, parameters, seed, at); });
    for (int axis = 0; axis < 3; ++axis)
        for (const double speed : settings.speeds_m_per_s) {
            const auto [there, given] = drag(parameters, axis, speed);
            const auto [back, givenBack] = drag(parameters, axis, -speed);
            v.drags.push_back({axis, speed, 0.5 * (there + back), 0.5 * (given + givenBack)});
        }
    return v;
}

} // namespace chiron::mechanisms
