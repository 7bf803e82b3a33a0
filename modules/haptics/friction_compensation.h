// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/device_sample.h"
#include "devices/api/device_descriptor.h"
#include "devices/api/kinematics.h"

#include <array>

namespace chiron::haptics {

/// Feed-forward of a mechanism's own dry friction (P2, "gravity and friction compensation", after Tholey).
/// While an axis moves, its motor helps it with a share of the identified Coulomb friction:
///   τ_i = c F_c,i · sign(q̇_i) · min(1, max(0, |q̇_i| − r_i)/w_i)
///   r_i = 2 counts/15 ms
///   w_i = c F_c,i/(4 σ_2,i)
/// q̇ is the loop's velocity estimate. The compensation of the tool, in D, is the wrench on the hand that
/// corresponds to these efforts.
///
/// Together with the friction that is there, it never makes energy: c ≤ kMost, so while an axis slides, the
/// help is less than what friction takes at any speed. At a reversal the estimate is late, and help in the
/// old direction only takes more energy. At rest, within r_i, there is no help, so a tool that is held still
/// stays still. Viscous friction is not compensated, because it calms the mechanism. w_i keeps the help from
/// rising with speed faster than four times the viscous friction, which a light hand (2 N·s/m) on the
/// mechanism still outweighs; a steeper rise would make slow motion stick and slip.
///
/// Pure: a function of sample and rates.
/// Thread: haptic; construction from a descriptor is set-up.
class FrictionCompensation {
public:
    static constexpr double kMost = devices::kMostFrictionCompensation; ///< largest c
    static constexpr double kSteepest = 4.0;    ///< largest slope of the help, in multiples of the viscous
                                                ///< friction
    static constexpr double kWindow_s = 0.015;  ///< window of the velocity estimate
    static constexpr double kRest_counts = 2.0; ///< counts per window up to which an axis may be at rest

    FrictionCompensation() = default;
    explicit FrictionCompensation(const devices::DeviceDescriptor& device) noexcept;

    bool active() const noexcept { return m_active; }
    /// Returns zero if nothing is compensated. `rates` are in counts/s, as the velocity estimator gives them.
    core::Wrench wrench_D(const devices::IToolKinematics& kinematics, const core::DeviceSample& sample,
                          const devices::AxisValues& rates) const noexcept;
    /// Returns the efforts of the axes, N or N·m.
    devices::AxisValues efforts(const devices::AxisValues& rates) const noexcept;

private:
    struct Axis {
        double resolution = 1.0;
        double most = 0.0;  ///< c F_c; 0: no compensation
        double rest = 0.0;  ///< r, in the axis's unit per second
        double width = 1.0; ///< w
    };
    std::array<Axis, core::kMaxCoordinates> m_axes{};
    bool m_active = false;
    bool m_turns = false; ///< the device gives torque; otherwise forces alone help its axes
};

} // namespace chiron::haptics
