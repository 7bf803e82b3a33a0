// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/friction_compensation.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace chiron::haptics {

namespace {

using Columns = Eigen::Matrix<double, core::kMaxCoordinates, 6>;

constexpr double kLever_m = 0.1; ///< makes torques comparable with forces, for the solver alone
constexpr double kRidge = 1e-9;  ///< of the largest entry: what no axis drives stays zero

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
        efforts[i] = std::copysign(axis.most * std::clamp((std::abs(speed) - axis.rest) / axis.width, 0.0, 1.0), speed);
    }
    return efforts;
}

core::Wrench FrictionCompensation::wrench_D(const devices::IToolKinematics& kinematics, const core::DeviceSample& sample,
                                            const devices::AxisValues& rates) const noexcept {
    core::Wrench wrench;
    if (!m_active)
        return wrench;
    const devices::AxisValues wanted = efforts(rates);
    if (std::all_of(wanted.begin(), wanted.end(), [](double effort) { return effort == 0.0; }))
        return wrench;
    // τ = A f with A = Jᵀ column by column: f of least squares. A compensated axis has a motor, so τ lies in what A gives.
    Columns A;
    Eigen::Matrix<double, core::kMaxCoordinates, 1> tau;
    for (Eigen::Index column = 0; column < 6; ++column) {
        const devices::AxisValues efforts = kinematics.efforts(sample, unitWrench(column));
        for (Eigen::Index row = 0; row < A.rows(); ++row)
            A(row, column) = m_axes[static_cast<std::size_t>(row)].most > 0.0 && (column < 3 || m_turns) ? efforts[static_cast<std::size_t>(row)] : 0.0;
    }
    for (Eigen::Index row = 0; row < tau.rows(); ++row)
        tau[row] = wanted[static_cast<std::size_t>(row)];
    Eigen::Matrix<double, 6, 6> square = A.transpose() * A;
    const double ridge = kRidge * square.diagonal().maxCoeff();
    if (!(ridge > 0.0) || !std::isfinite(ridge))
        return wrench;
    square.diagonal().array() += ridge;
    const Eigen::Matrix<double, 6, 1> f = square.ldlt().solve(Eigen::Matrix<double, 6, 1>(A.transpose() * tau));
    if (!f.allFinite())
        return wrench;
    wrench.force = f.head<3>();
    wrench.torque = kLever_m * f.tail<3>();
    return wrench;
}

} // namespace chiron::haptics
