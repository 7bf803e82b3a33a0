// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/api/device_descriptor.h"
#include "devices/api/kinematics.h"
#include "mechanisms/fingertip_arm_chain.h"

namespace chiron::devices {

/// Kinematics "fingertip_arm": P3's console arm with a fingertip platform. Axes: yaw, shoulder, elbow (rad,
/// absolute encoders), wrist_x, wrist_y, wrist_z (rad: the rotation vector that the handle's IMU reports),
/// platform_pitch, platform_roll (rad: angles that the platform's own IMU reports; they do not move the
/// tool). Parameters: {x, y, z of this finger's pad from the wrist's middle, in T; x, y, z of the shoulder,
/// in D; length of the upper arm, of the forearm; all m}. With p_arm from mechanisms::FingertipArmPlace and J
/// its Jacobian:
///   q_DT = exp(r),  p_DT = p_arm(θ) + q_DT·o,  w = J_l(r) r˙ (left Jacobian of SO(3)),  v = J(θ) θ˙ + w ×
///   q_DT·o.
/// T: the identity is the pad facing down (−z_T), x_T across the finger. The arm has no motors: no axis takes
/// part in any wrench, so every effort is zero. Pure. Source: P3 §2.2; models.md §3.
/// (Stored sessions of models id 1 and 2: fingertip_sliding_kinematics.h.)
/// Thread: any.
class FingertipArmKinematics final : public IToolKinematics {
public:
    static constexpr const char* kId = "fingertip_arm";
    static constexpr std::size_t kAxes = 8;
    static constexpr std::size_t kWrist = 3;    ///< first axis of the wrist
    static constexpr std::size_t kPlatform = 6; ///< pitch, then roll

    FingertipArmKinematics(const std::array<double, kAxes>& resolution, double jawResolution_rad,
                           const core::Vec3& pad_T, const mechanisms::FingertipArmGeometry& geometry) noexcept
        : m_resolution(resolution), m_jawResolution_rad(jawResolution_rad), m_pad_T(pad_T),
          m_place(geometry) {}
    /// Creates the kinematics.
    /// Errors: badInput if id, axes, units or parameters do not fit.
    static core::Result<FingertipArmKinematics> create(const DeviceDescriptor& descriptor);
    ~FingertipArmKinematics() override;
    FingertipArmKinematics(const FingertipArmKinematics&) = default;
    FingertipArmKinematics& operator=(const FingertipArmKinematics&) = default;

    core::ToolState pose(const core::DeviceSample& sample) const noexcept override;
    void velocity(const core::DeviceSample& sample, const AxisValues& countRates, core::Vec3& v_DT,
                  core::Vec3& w_DT) const noexcept override;
    AxisValues efforts(const core::DeviceSample&, const core::Wrench&) const noexcept override { return {}; }

private:
    core::Vec3 triple(const core::DeviceSample& sample, std::size_t first) const noexcept;

    std::array<double, kAxes> m_resolution;
    double m_jawResolution_rad;
    core::Vec3 m_pad_T;
    mechanisms::FingertipArmPlace m_place;
};

} // namespace chiron::devices
