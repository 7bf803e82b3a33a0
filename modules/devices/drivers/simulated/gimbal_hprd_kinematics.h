// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/api/device_descriptor.h"
#include "devices/api/kinematics.h"
#include "mechanisms/gimbal_kinematics.h"

#include <array>

namespace chiron::devices {

/// Kinematics "gimbal_hprd": computes the tip of P2's gimbal in D from the counts of heading, pitch, roll and
/// depth. Pure. Descriptor: axes[0..3] give the resolutions (rad, rad, rad, m); kinematicsParameters = {pivot
/// height in m, force map: 0 exact Jᵀ, 1 as published}.
class GimbalHprdKinematics final : public IToolKinematics {
public:
    static constexpr const char* kId = "gimbal_hprd";

    /// Creates the kinematics.
    /// Errors: badInput if the id, the number of axes or parameters, a resolution or the map is wrong.
    static core::Result<GimbalHprdKinematics> create(const DeviceDescriptor& descriptor);
    /// The force map of a descriptor; exact where it has none.
    static mechanisms::PolarMap mapOf(const DeviceDescriptor& descriptor);

    GimbalHprdKinematics(const std::array<double, 4>& resolution, double jawResolution_rad,
                         double pivotHeight_m, mechanisms::PolarMap map) noexcept;
    GimbalHprdKinematics(const GimbalHprdKinematics&) = default;
    GimbalHprdKinematics& operator=(const GimbalHprdKinematics&) = default;
    ~GimbalHprdKinematics() override; ///< in the set-up file, because a deleting destructor frees memory

    core::ToolState pose(const core::DeviceSample& sample) const noexcept override;
    void velocity(const core::DeviceSample& sample, const AxisValues& countRates, core::Vec3& v_DT,
                  core::Vec3& w_DT) const noexcept override;
    AxisValues efforts(const core::DeviceSample& sample,
                       const core::Wrench& wrench_D) const noexcept override;

private:
    mechanisms::GimbalCoordinates coordinates(const core::DeviceSample& sample) const noexcept;

    std::array<double, 4> m_resolution;
    double m_jawResolution_rad;
    mechanisms::GimbalKinematics m_gimbal;
    mechanisms::PolarMap m_map;
};

} // namespace chiron::devices
