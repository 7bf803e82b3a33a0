// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/api/device_descriptor.h"
#include "devices/api/kinematics.h"
#include "mechanisms/spherical_joint.h"

namespace chiron::devices {

/// Kinematics "endoscope_pose": the axes are the tip's x, y, z in D (m) and the endoscope's pitch, yaw and
/// roll (rad, from "looking along +y_D with y_T up"), as mechanisms::SphericalJoint defines them. No
/// parameters. Pure.
/// Thread: any.
class EndoscopePoseKinematics final : public IToolKinematics {
public:
    static constexpr const char* kId = "endoscope_pose";
    static constexpr std::size_t kAxes = 6;

    /// Creates the kinematics.
    /// Errors: badInput unless the descriptor has this id, 3 axes in metres and 3 in radians, all of positive
    /// resolution.
    static core::Result<EndoscopePoseKinematics> create(const DeviceDescriptor& descriptor);
    explicit EndoscopePoseKinematics(const std::array<double, kAxes>& resolution) noexcept
        : m_resolution(resolution) {}
    ~EndoscopePoseKinematics() override;
    EndoscopePoseKinematics(const EndoscopePoseKinematics&) = default;
    EndoscopePoseKinematics& operator=(const EndoscopePoseKinematics&) = default;

    core::ToolState pose(const core::DeviceSample& sample) const noexcept override;
    void velocity(const core::DeviceSample& sample, const AxisValues& countRates, core::Vec3& v_DT,
                  core::Vec3& w_DT) const noexcept override;
    AxisValues efforts(const core::DeviceSample& sample,
                       const core::Wrench& wrench_D) const noexcept override;

private:
    template <class Counts> core::Vec3 triple(const Counts& counts, std::size_t first) const noexcept {
        return {counts[first] * m_resolution[first], counts[first + 1] * m_resolution[first + 1],
                counts[first + 2] * m_resolution[first + 2]};
    }
    mechanisms::SphericalJoint joint(const core::DeviceSample& sample) const noexcept;

    std::array<double, kAxes> m_resolution;
};

} // namespace chiron::devices
