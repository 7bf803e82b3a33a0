// SPDX-License-Identifier: GPL-3.0-or-later
#include "mechanisms/five_bar_dynamics.h"

#include <cmath>

namespace chiron::mechanisms {

using core::Vec2;
using core::Vec3;

FiveBarDynamics::FiveBarDynamics(const FiveBarPlantParameters& parameters) noexcept
    : m_parameters(parameters), m_kinematics(parameters.geometry) {
    place(FiveBarVector::Zero());
}

void FiveBarDynamics::place(const FiveBarVector& q) noexcept {
    m_loop = m_kinematics.loop(q[0], q[1]);
    m_joint = SphericalJoint({m_parameters.mountingPitch_rad + q[2], q[3], q[4]});
    m_behind = -m_parameters.centreOfMassBehindTip_m * m_joint.view_D();
    for (int k = 0; k < 2; ++k)
        m_partial[static_cast<std::size_t>(k)] = FiveBarKinematics::toD(m_loop.jacobian.col(k));
    for (int k = 0; k < 3; ++k)
        m_partial[static_cast<std::size_t>(k + 2)] = m_joint.column(k).cross(m_behind);
}

Vec3 FiveBarDynamics::inertiaTimes(const Vec3& w) const noexcept {
    const double across = m_parameters.acrossInertia_kgm2;
    const Vec3& a = m_joint.view_D();
    return across * w + (m_parameters.axialInertia_kgm2 - across) * a.dot(w) * a;
}

FiveBarMatrix FiveBarDynamics::inertia() const noexcept {
    const FiveBarPlantParameters& p = m_parameters;
    FiveBarMatrix m;
    for (int k = 0; k < 5; ++k) {
        for (int l = 0; l <= k; ++l) {
            double value = p.endoscopeMass_kg *
                           m_partial[static_cast<std::size_t>(k)].dot(m_partial[static_cast<std::size_t>(l)]);
            if (l >= 2)
                value += m_joint.column(k - 2).dot(inertiaTimes(m_joint.column(l - 2)));
            m(k, l) = m(l, k) = value;
        }
    }
    const Eigen::Matrix2d tips = m_loop.jacobian.transpose() * m_loop.jacobian;
    Eigen::Matrix2d links = (p.jointMass_kg + 2.0 * p.distalMass_kg / 3.0) * tips;
    const double own =
        (p.proximalMass_kg + p.distalMass_kg) / 3.0 * p.geometry.proximal_m * p.geometry.proximal_m;
    for (int leg = 0; leg < 2; ++leg) {
        const Vec2& elbow = m_loop.tangent[static_cast<std::size_t>(leg)];
        links(leg, leg) += own;
        for (int k = 0; k < 2; ++k) {
            const double shared = p.distalMass_kg / 6.0 * elbow.dot(m_loop.jacobian.col(k));
            links(leg, k) += shared;
            links(k, leg) += shared;
        }
    }
    m.topLeftCorner<2, 2>() += links;
    return m;
}

FiveBarVector FiveBarDynamics::bias(const FiveBarVector& rates) const noexcept {
    const FiveBarPlantParameters& p = m_parameters;
    const Vec2 bars = rates.head<2>();
    const Vec3 angles = rates.tail<3>();
    const Vec2 tip = m_loop.biasAcceleration(bars);
    const Vec3 w = m_joint.angularVelocity_D(angles);
    const Vec3 turning = m_joint.biasAcceleration_D(angles);
    const Vec3 centre = FiveBarKinematics::toD(tip) + turning.cross(m_behind) + w.cross(w.cross(m_behind));
    const Vec3 torque = inertiaTimes(turning) + w.cross(inertiaTimes(w));

    FiveBarVector h;
    for (int k = 0; k < 5; ++k) {
        h[k] = p.endoscopeMass_kg * m_partial[static_cast<std::size_t>(k)].dot(centre);
        if (k >= 2)
            h[k] += m_joint.column(k - 2).dot(torque);
    }
    Vec2 atTip = p.jointMass_kg * tip;
    for (int leg = 0; leg < 2; ++leg) {
        const Vec2 elbow = m_loop.elbowBias(leg, bars[leg]);
        atTip += p.distalMass_kg / 6.0 * (2.0 * tip + elbow);
        h[leg] +=
            p.distalMass_kg / 6.0 * m_loop.tangent[static_cast<std::size_t>(leg)].dot(2.0 * elbow + tip);
    }
    h.head<2>() += m_loop.jacobian.transpose() * atTip;
    return h;
}

FiveBarVector FiveBarDynamics::gravity() const noexcept {
    const FiveBarPlantParameters& p = m_parameters;
    FiveBarVector g;
    for (int k = 0; k < 5; ++k)
        g[k] = p.endoscopeMass_kg * m_partial[static_cast<std::size_t>(k)].z();
    g.head<2>() += (p.jointMass_kg + p.distalMass_kg) * m_loop.jacobian.row(1).transpose();
    for (int leg = 0; leg < 2; ++leg)
        g[leg] +=
            0.5 * (p.proximalMass_kg + p.distalMass_kg) * m_loop.tangent[static_cast<std::size_t>(leg)].y();
    return core::kStandardGravity * g;
}

double FiveBarDynamics::potential_J() const noexcept {
    const FiveBarPlantParameters& p = m_parameters;
    const double elbows = m_loop.elbow[0].y() + m_loop.elbow[1].y();
    return core::kStandardGravity * (p.endoscopeMass_kg * (m_loop.tip.y() + m_behind.z()) +
                                     (p.jointMass_kg + p.distalMass_kg) * m_loop.tip.y() +
                                     0.5 * (p.proximalMass_kg + p.distalMass_kg) * elbows);
}

FiveBarVector FiveBarDynamics::efforts(const core::Wrench& wrench_D) const noexcept {
    FiveBarVector tau;
    tau.head<2>() = FiveBarKinematics::efforts(m_loop, wrench_D.force);
    tau.tail<3>() = m_joint.efforts(wrench_D.torque);
    return tau;
}

core::Wrench FiveBarDynamics::wrench_D(const FiveBarVector& efforts) const noexcept {
    return {FiveBarKinematics::force_D(m_loop, efforts.head<2>()), m_joint.torque_D(efforts.tail<3>())};
}

FiveBarVector FiveBarDynamics::solve(FiveBarMatrix m, FiveBarVector b) noexcept {
    FiveBarVector pivot; // reciprocals of D in M = L D Lᵀ; L grows in the lower half, L D in the upper
    for (int k = 0; k < 5; ++k) {
        pivot[k] = 1.0 / m(k, k);
        for (int i = k + 1; i < 5; ++i) {
            m(i, k) = m(k, i) * pivot[k];
            b[i] -= m(i, k) * b[k];
            for (int l = k + 1; l <= i; ++l)
                m(l, i) -= m(i, k) * m(k, l);
        }
    }
    for (int k = 4; k >= 0; --k) {
        b[k] *= pivot[k];
        for (int i = k + 1; i < 5; ++i)
            b[k] -= m(i, k) * b[i];
    }
    return b;
}

} // namespace chiron::mechanisms
