// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/device_sample.h"
#include "devices/api/device_descriptor.h"
#include "devices/api/kinematics.h"

#include <array>

namespace chiron::haptics {

/// Feed-forward of a mechanism's own dry friction (P2, "gravity and friction compensation", after Tholey): while an axis moves its
/// motor helps it with a share of the Coulomb friction that was identified,
///   τ_i = c F_c,i · sign(q̇_i) · min(1, max(0, |q̇_i| − r_i)/w_i),  r_i = 2 counts/15 ms,  w_i = c F_c,i/(4 σ_2,i)
/// q̇ is the house's estimate. The hand's wrench with these efforts is the tool's compensation in D.
///
/// It never makes energy together with the friction that is there: c ≤ kMost, so while an axis slides the help is less than what
/// friction takes at any speed; at a reversal the estimate is late, and help that still goes the old way only takes more. At rest, within
/// r_i, there is none, so what holds still stays held. Viscous friction is left alone: it is what calms the mechanism. w_i keeps the help
/// from rising with speed faster than four times the viscous friction, which a light hand (2 N·s/m) on it still outweighs; a steeper
/// rise would make slow motion stick and slip.
/// kMost is 0.8 because friction identified within 1 % (mechanisms/friction_identification.h) changes by a tenth and more with
/// temperature, load and wear, and overcompensation moves the tool by itself.
/// Pure: a function of sample and rates. Thread: haptic; set-up is configure().
class FrictionCompensation {
public:
    static constexpr double kMost = 0.8;        ///< c, at most
    static constexpr double kSteepest = 4.0;    ///< times the viscous friction
    static constexpr double kWindow_s = 0.015;  ///< of the velocity estimate
    static constexpr double kRest_counts = 2.0; ///< in a window: may be rest

    FrictionCompensation() = default;
    explicit FrictionCompensation(const devices::DeviceDescriptor& device) noexcept;

    bool active() const noexcept { return m_active; }
    /// `rates` in counts/s, as the velocity estimator gives them. Zero where nothing is compensated.
    core::Wrench wrench_D(const devices::IToolKinematics& kinematics, const core::DeviceSample& sample,
                          const devices::AxisValues& rates) const noexcept;
    /// The axes' efforts, N or N·m.
    devices::AxisValues efforts(const devices::AxisValues& rates) const noexcept;

private:
    struct Axis {
        double resolution = 1.0;
        double most = 0.0;  ///< c F_c; 0: none
        double rest = 0.0;  ///< r, of the axis, a second
        double width = 1.0; ///< w
    };
    std::array<Axis, core::kMaxCoordinates> m_axes{};
    bool m_active = false;
    bool m_turns = false; ///< the device gives torque; else its axes are helped by force alone
};

} // namespace chiron::haptics
