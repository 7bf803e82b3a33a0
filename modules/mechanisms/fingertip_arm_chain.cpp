// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/fingertip_arm_chain.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::mechanisms {

using core::Mat3;
using core::Vec3;

namespace {

constexpr double kSingular = 1e-6;

/// A tube of a given length along −y from its joint: a thin rod, with a bearing's radius about its own axis.
ChainLink tube(const Vec3& origin, double length, double mass) noexcept {
    constexpr double kRadius_m = 0.012;
    const double across = mass * (length * length / 12.0 + 0.5 * kRadius_m * kRadius_m),
                 along = mass * kRadius_m * kRadius_m;
    return {origin, Vec3::UnitX(), mass, Vec3(0.0, -0.5 * length, 0.0),
            Vec3(across, along, across).asDiagonal()};
}

/// A ring about the wrist's middle in the plane across its axis of symmetry.
Mat3 ring(double mass, double radius, int symmetry) noexcept {
    Vec3 moments = Vec3::Constant(0.5 * mass * radius * radius);
    moments[symmetry] *= 2.0;
    return moments.asDiagonal();
}

} // namespace

FingertipArmDynamics::Links fingertipArmLinks(const FingertipArmParameters& p) noexcept {
    const FingertipArmGeometry& g = p.geometry;
    const Vec3 none = Vec3::Zero();
    const double handle = p.handleMass_kg * p.handleRadius_m * p.handleRadius_m;
    const double lever = p.leverMass_kg * p.leverLength_m * p.leverLength_m / 12.0;
    return {ChainLink{g.shoulder_D, Vec3::UnitZ(), p.columnMass_kg, none,
                      p.columnInertia_kgm2 * Mat3::Identity()},
            tube(none, g.upper_m, p.upperMass_kg),
            tube(Vec3(0.0, -g.upper_m, 0.0), g.fore_m, p.foreMass_kg),
            ChainLink{Vec3(0.0, -g.fore_m, 0.0), Vec3::UnitX(), p.ringMass_kg, none,
                      ring(p.ringMass_kg, p.ringRadius_m, 2)},
            ChainLink{none, Vec3::UnitY(), p.ringMass_kg, none, ring(p.ringMass_kg, p.ringRadius_m, 0)},
            ChainLink{none, Vec3::UnitZ(), p.handleMass_kg, p.handleCentre_T, handle * Mat3::Identity()},
            ChainLink{p.leverPivot_T, Vec3::UnitZ(), p.leverMass_kg, Vec3(0.0, 0.5 * p.leverLength_m, 0.0),
                      Vec3(lever, 0.01 * lever, lever).asDiagonal()}};
}

Vec3 FingertipArmPlace::place_D(const Vec3& q) const noexcept {
    const double out = m_geometry.upper_m * std::cos(q[1]) + m_geometry.fore_m * std::cos(q[1] + q[2]);
    const double down = m_geometry.upper_m * std::sin(q[1]) + m_geometry.fore_m * std::sin(q[1] + q[2]);
    return m_geometry.shoulder_D + Vec3(out * std::sin(q[0]), -out * std::cos(q[0]), -down);
}

Mat3 FingertipArmPlace::jacobian(const Vec3& q) const noexcept {
    const double s = std::sin(q[0]), c = std::cos(q[0]);
    const double outFore = m_geometry.fore_m * std::cos(q[1] + q[2]),
                 downFore = m_geometry.fore_m * std::sin(q[1] + q[2]);
    const double out = m_geometry.upper_m * std::cos(q[1]) + outFore,
                 down = m_geometry.upper_m * std::sin(q[1]) + downFore;
    Mat3 j;
    j << out * c, -down * s, -downFore * s, //
        out * s, down * c, downFore * c,    //
        0.0, -out, -outFore;
    return j;
}

double FingertipArmPlace::conditionNumber(const Mat3& jacobian) noexcept {
    // Eigenvalues of JᵀJ, symmetric 3 × 3, in closed form.
    const Mat3 a = jacobian.transpose() * jacobian;
    const double mean = a.trace() / 3.0;
    const Mat3 b = a - mean * Mat3::Identity();
    const double spread = std::sqrt(b.squaredNorm() / 6.0);
    if (!(spread > 0.0))
        return 1.0;
    const double angle =
        std::acos(std::clamp(0.5 * b.determinant() / (spread * spread * spread), -1.0, 1.0)) / 3.0;
    const double largest = mean + 2.0 * spread * std::cos(angle);
    const double smallest = mean + 2.0 * spread * std::cos(angle + 2.0 * core::kPi / 3.0);
    return smallest > 1e-12 * largest ? std::sqrt(largest / smallest)
                                      : std::numeric_limits<double>::infinity();
}

const char* wordsFor(ArmReach reach) noexcept {
    switch (reach) {
    case ArmReach::reached:
        return "reached";
    case ArmReach::notANumber:
        return "the pose is not a number";
    case ArmReach::tooFar:
        return "the arm is too short, or cannot fold so far";
    case ArmReach::overShoulder:
        return "the place is straight above or below the shoulder";
    case ArmReach::gimbalLock:
        return "two axes of the wrist are in line";
    case ArmReach::beyondTravel:
        return "a joint's travel ends before";
    }
    return "";
}

ArmPosture fingertipArmPosture(const FingertipArmParameters& parameters, const Vec3& p_DT,
                               const core::Quat& q_DT, double jaw_rad) noexcept {
    ArmPosture posture;
    const double norm = q_DT.norm();
    if (!p_DT.allFinite() || !std::isfinite(norm) || !(norm > 0.5) || !std::isfinite(jaw_rad))
        return posture;
    const FingertipArmGeometry& g = parameters.geometry;
    const Vec3 from = p_DT - g.shoulder_D;
    const double out = std::hypot(from.x(), from.y()), far2 = from.squaredNorm();
    const double cosine = (far2 - g.upper_m * g.upper_m - g.fore_m * g.fore_m) / (2.0 * g.upper_m * g.fore_m);
    posture.reach = ArmReach::tooFar;
    if (!(std::abs(cosine) <= 1.0))
        return posture;
    posture.reach = ArmReach::overShoulder;
    if (!(out > kSingular))
        return posture;
    FingertipArmJoints& q = posture.q;
    q[0] = std::atan2(from.x(), -from.y());
    q[2] = std::acos(cosine); // the elbow above the line from shoulder to wrist
    q[1] = std::atan2(-from.z(), out) -
           std::atan2(g.fore_m * std::sin(q[2]), g.upper_m + g.fore_m * std::cos(q[2]));

    const double s = std::sin(q[0]), c = std::cos(q[0]), sf = std::sin(q[1] + q[2]),
                 cf = std::cos(q[1] + q[2]);
    Mat3 fore; // R_z(q₁) R_x(q₂ + q₃)
    fore << c, -s * cf, s * sf, s, c * cf, -c * sf, 0.0, sf, cf;
    const Mat3 wrist = fore.transpose() * q_DT.normalized().toRotationMatrix();
    q[4] = std::asin(std::clamp(wrist(0, 2), -1.0, 1.0));
    posture.reach = ArmReach::gimbalLock;
    if (!(std::hypot(wrist(0, 0), wrist(0, 1)) > kSingular))
        return posture;
    q[3] = std::atan2(-wrist(1, 2), wrist(2, 2));
    q[5] = std::atan2(-wrist(0, 1), wrist(0, 0));
    q[6] = jaw_rad;
    posture.reach = ArmReach::reached;
    for (int joint = 0; joint < FingertipArmParameters::kJoints && posture.reach == ArmReach::reached;
         ++joint) {
        const auto i = static_cast<std::size_t>(joint);
        if (q[joint] < parameters.minimum[i] || q[joint] > parameters.maximum[i]) {
            posture.reach = ArmReach::beyondTravel;
            posture.joint = joint;
        }
    }
    return posture;
}

} // namespace chiron::mechanisms
