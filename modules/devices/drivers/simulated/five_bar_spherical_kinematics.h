// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/api/device_descriptor.h"
#include "devices/api/kinematics.h"
#include "mechanisms/five_bar_kinematics.h"
#include "mechanisms/spherical_joint.h"

namespace chiron::devices {

/// Kinematics "five_bar_spherical": P1's linkage and joint (mechanisms/five_bar_kinematics.h,
/// spherical_joint.h) computed from counts. Axes: theta1, theta2, pitch (from its mounting zero), yaw, roll,
/// all rad. Parameters: {l1, l2, half base, base forward, base up (m), mounting pitch (rad)}. A force normal
/// to the plane has no motor and is lost. Pure.
/// Thread: any.
class FiveBarSphericalKinematics final : public IToolKinematics {
public:
    static constexpr const char* kId = "five_bar_spherical";
    static constexpr std::size_t kAxes = 5;

    FiveBarSphericalKinematics(const std::array<double, kAxes>& resolution, double jawResolution_rad,
                               const mechanisms::FiveBarGeometry& geometry, double mountingPitch_rad) noexcept
        : m_resolution(resolution), m_jawResolution_rad(jawResolution_rad), m_linkage(geometry),
          m_mountingPitch_rad(mountingPitch_rad) {}
    /// Creates the kinematics.
    /// Errors: badInput if id, axes or parameters do not fit.
    static core::Result<FiveBarSphericalKinematics> create(const DeviceDescriptor& descriptor);
    ~FiveBarSphericalKinematics() override;
    FiveBarSphericalKinematics(const FiveBarSphericalKinematics&) = default;
    FiveBarSphericalKinematics& operator=(const FiveBarSphericalKinematics&) = default;

    core::ToolState pose(const core::DeviceSample& sample) const noexcept override;
    void velocity(const core::DeviceSample& sample, const AxisValues& countRates, core::Vec3& v_DT,
                  core::Vec3& w_DT) const noexcept override;
    AxisValues efforts(const core::DeviceSample& sample,
                       const core::Wrench& wrench_D) const noexcept override;

private:
    double value(const core::DeviceSample& sample, std::size_t axis) const noexcept {
        return sample.counts[axis] * m_resolution[axis];
    }
    mechanisms::FiveBarLoop loop(const core::DeviceSample& sample) const noexcept;
    mechanisms::SphericalJoint joint(const core::DeviceSample& sample) const noexcept;

    std::array<double, kAxes> m_resolution;
    double m_jawResolution_rad;
    mechanisms::FiveBarKinematics m_linkage;
    double m_mountingPitch_rad;
};

} // namespace chiron::devices
