// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/friction_compensation.h"

#include <algorithm>
#include <cmath>

namespace chiron::haptics {

namespace {

using Columns = Eigen::Matrix<double, core::kMaxCoordinates, 6>;
using Square = Eigen::Matrix<double, 6, 6>;
using Vec6 = Eigen::Matrix<double, 6, 1>;

constexpr double kLever_m = 0.1; ///< makes torques comparable with forces, for the solver alone
constexpr double kRidge = 1e-9;  ///< share of the largest diagonal entry; directions that no axis drives stay
                                 ///< zero

/// Solves M x = y for a symmetric positive definite M by Cholesky decomposition (Eigen's own may allocate).
/// The result is not finite if M is not positive definite.
Vec6 solve(Square M, Vec6 y) noexcept {
    for (Eigen::Index j = 0; j < 6; ++j) {
        for (Eigen::Index k = 0; k < j; ++k)
            M(j, j) -= M(j, k) * M(j, k);
        M(j, j) = std::sqrt(M(j, j));
        for (Eigen::Index i = j + 1; i < 6; ++i) {
            for (Eigen::Index k = 0; k < j; ++k)
                M(i, j) -= M(i, k) * M(j, k);
            M(i, j) /= M(j, j);
        }
    }
    for (Eigen::Index i = 0; i < 6; ++i) {
        for (Eigen::Index k = 0; k < i; ++k)
            y[i] -= M(i, k) * y[k];
        y[i] /= M(i, i);
    }
    for (Eigen::Index i = 5; i >= 0; --i) {
        for (Eigen::Index k = i + 1; k < 6; ++k)
            y[i] -= M(k, i) * y[k];
        y[i] /= M(i, i);
    }
    return y;
}

core::Wrench unitWrench(Eigen::Index component) noexcept {
    core::Wrench wrench;
    if (component < 3)
        wrench.force[component] = 1.0;
    else
        wrench.torque[component - 3] = kLever_m;
    return wrench;
}

} // namespace

FrictionCompensation::FrictionCompensation(const devices::DeviceDescriptor& device) noexcept {
    const double share = std::clamp(device.frictionCompensation, 0.0, kMost);
    if (!device.rendersForce || !(share > 0.0))
        return;
    m_turns = device.maximumTorque_Nm > 0.0;
    for (std::size_t i = 0; i < std::min(device.axes.size(), m_axes.size()); ++i) {
        const devices::AxisDescriptor& axis = device.axes[i];
        Axis& mine = m_axes[i];
        mine.resolution = axis.resolution;
        if (!(axis.continuousRating > 0.0 && axis.coulombFriction > 0.0 && axis.viscousFriction > 0.0))
            continue;
        mine.most = share * axis.coulombFriction;
        mine.rest = kRest_counts * axis.resolution / kWindow_s;
        mine.width = mine.most / (kSteepest * axis.viscousFriction);
        m_active = true;
    }
}

devices::AxisValues FrictionCompensation::efforts(const devices::AxisValues& rates) const noexcept {
    devices::AxisValues efforts{};
    for (std::size_t i = 0; i < m_axes.size(); ++i) {
        const Axis& axis = m_axes[i];
        if (!(axis.most > 0.0))
            continue;
        const double speed = rates[i] * axis.resolution;
        efforts[i] = std::copysign(
            axis.most * std::clamp((std::abs(speed) - axis.rest) / axis.width, 0.0, 1.0), speed);
    }
    return efforts;
}

core::Wrench FrictionCompensation::wrench_D(const devices::IToolKinematics& kinematics,
                                            const core::DeviceSample& sample,
                                            const devices::AxisValues& rates) const noexcept {
    core::Wrench wrench;
    if (!m_active)
        return wrench;
    const devices::AxisValues wanted = efforts(rates);
    if (std::all_of(wanted.begin(), wanted.end(), [](double effort) { return effort == 0.0; }))
        return wrench;
    // Solves τ = A f for f by least squares; A = Jᵀ is computed column by column. A compensated axis has a
    // motor, so τ lies in the range of A.
    Columns A;
    Eigen::Matrix<double, core::kMaxCoordinates, 1> tau;
    for (Eigen::Index column = 0; column < 6; ++column) {
        const devices::AxisValues efforts = kinematics.efforts(sample, unitWrench(column));
        for (Eigen::Index row = 0; row < A.rows(); ++row)
            A(row, column) = m_axes[static_cast<std::size_t>(row)].most > 0.0 && (column < 3 || m_turns)
                                 ? efforts[static_cast<std::size_t>(row)]
                                 : 0.0;
    }
    for (Eigen::Index row = 0; row < tau.rows(); ++row)
        tau[row] = wanted[static_cast<std::size_t>(row)];
    Square square = Square::Zero();
    Vec6 right = Vec6::Zero();
    for (Eigen::Index i = 0; i < 6; ++i) {
        for (Eigen::Index row = 0; row < A.rows(); ++row)
            right[i] += A(row, i) * tau[row];
        for (Eigen::Index j = 0; j < 6; ++j)
            for (Eigen::Index row = 0; row < A.rows(); ++row)
                square(i, j) += A(row, i) * A(row, j);
    }
    const double ridge = kRidge * square.diagonal().maxCoeff();
    if (!(ridge > 0.0) || !std::isfinite(ridge))
        return wrench;
    square.diagonal().array() += ridge;
    const Vec6 f = solve(square, right);
    if (!f.allFinite())
        return wrench;
    wrench.force = f.head<3>();
    wrench.torque = kLever_m * f.tail<3>();
    return wrench;
}

} // namespace chiron::haptics
