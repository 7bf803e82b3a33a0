// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/api/device_descriptor.h"
#include "devices/api/kinematics.h"

namespace chiron::devices {

/// Kinematics "cartesian": the axes are the tip's coordinates themselves.
///   p_DT = (x, y, z), axes 0–2 in metres;
///   q_DT = exp(r), axes 3–5, if there are any, in radians: the rotation vector r (axis times angle);
///   v_DT = ṗ; w_DT = J(r) ṙ with the left Jacobian of SO(3),
///   J(r) = 1 + (1 - cos θ)/θ² [r]× + (θ - sin θ)/θ³ [r]×², θ = ‖r‖
/// (Chirikjian 2011, Stochastic Models, Information Theory, and Lie Groups, vol. 2, §10.6). Efforts: f on
/// axes 0–2, J(r)ᵀ τ on axes 3–5, so that power is conserved.
/// Parameters: none beyond the axes' resolutions. Pure.
/// Thread: any; allocates nothing after creation.
class CartesianKinematics final : public IToolKinematics {
public:
    /// Creates the kinematics.
    /// Errors: badInput unless the descriptor has 3 axes in metres, or 3 in metres and 3 in radians, of
    /// positive resolution.
    static core::Result<CartesianKinematics> create(const DeviceDescriptor& descriptor);
    CartesianKinematics(const CartesianKinematics&) = default;
    CartesianKinematics& operator=(const CartesianKinematics&) = default;
    ~CartesianKinematics() override;

    core::ToolState pose(const core::DeviceSample& sample) const noexcept override;
    void velocity(const core::DeviceSample& sample, const AxisValues& countRates, core::Vec3& v_DT,
                  core::Vec3& w_DT) const noexcept override;
    AxisValues efforts(const core::DeviceSample& sample,
                       const core::Wrench& wrench_D) const noexcept override;

private:
    CartesianKinematics() = default;
    core::Vec3 rotationVector(const core::DeviceSample& sample) const noexcept;

    AxisValues m_resolution{}; ///< m or rad per count
    double m_jawResolution_rad = 0.0;
    bool m_turns = false; ///< axes 3–5 exist
};

} // namespace chiron::devices
