// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/api/device_descriptor.h"
#include "devices/api/kinematics.h"

namespace chiron::devices {

/// Kinematics "fingertip_arm" of sessions of models id 1 and 2, for an arm whose axes were its three
/// translations: x, y, z (m), wrist_x, wrist_y, wrist_z (rad: the rotation vector that the wrist's IMU
/// reports), platform_pitch, platform_roll (rad: angles that the platform's own IMU reports; they do not move
/// the tool). Parameters: {x, y, z of this finger's pad from the arm's end, in T, m}.
///   q_DT = exp(r),  p_DT = p_arm + q_DT·o,  w = J(r) r˙ (left Jacobian of SO(3)),  v = p˙_arm + w × q_DT·o.
/// Only for stored sessions: no device has these kinematics any more. Every effort is zero. Pure. Source:
/// P3 §2.2; models.md §3.
/// Thread: any.
class FingertipSlidingKinematics final : public IToolKinematics {
public:
    static constexpr const char* kId = "fingertip_arm";
    static constexpr std::size_t kAxes = 8;
    static constexpr std::size_t kWrist = 3;    ///< first axis of the wrist
    static constexpr std::size_t kPlatform = 6; ///< pitch, then roll

    FingertipSlidingKinematics(const std::array<double, kAxes>& resolution, double jawResolution_rad,
                               const core::Vec3& pad_T) noexcept
        : m_resolution(resolution), m_jawResolution_rad(jawResolution_rad), m_pad_T(pad_T) {}
    /// Creates the kinematics.
    /// Errors: badInput if id, axes, units or parameters do not fit.
    static core::Result<FingertipSlidingKinematics> create(const DeviceDescriptor& descriptor);
    ~FingertipSlidingKinematics() override;
    FingertipSlidingKinematics(const FingertipSlidingKinematics&) = default;
    FingertipSlidingKinematics& operator=(const FingertipSlidingKinematics&) = default;

    core::ToolState pose(const core::DeviceSample& sample) const noexcept override;
    void velocity(const core::DeviceSample& sample, const AxisValues& countRates, core::Vec3& v_DT,
                  core::Vec3& w_DT) const noexcept override;
    AxisValues efforts(const core::DeviceSample&, const core::Wrench&) const noexcept override { return {}; }

private:
    core::Vec3 triple(const core::DeviceSample& sample, std::size_t first) const noexcept;

    std::array<double, kAxes> m_resolution;
    double m_jawResolution_rad;
    core::Vec3 m_pad_T;
};

} // namespace chiron::devices
