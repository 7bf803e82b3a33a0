// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device.h"
#include "devices/api/pointer_mailbox.h"
#include "devices/drivers/cartesian/cartesian_kinematics.h"
#include "devices/drivers/keyboard_mouse/motion_intake.h"

#include <memory>

namespace chiron::devices {

struct KeyboardMouseSettings {
    std::array<double, 3> minimum_m{-0.080, -0.080, -0.030}; ///< workspace in D
    std::array<double, 3> maximum_m{0.080, 0.080, 0.080};
    std::array<double, 3> home_m{0.0, 0.0, 0.060};
    /// Opening angle of a grasper's jaw at its stop, at most 1.6; 0: a tool without a jaw.
    double widestJaw_rad = 0.0;
    double homeJaw_rad = 0.0; ///< at open(); 0..widestJaw_rad
    PseudoHaptics pseudoHaptics{};
    /// Time constant with which the tool follows the hand. Pointers and wheels report in jumps, 8 to 16 ms
    /// apart, which do not represent the speed of any hand. 0 (as the hand reports) to 0.2 s.
    double following_s = 0.0;
};

/// A mouse and a keyboard as an input-only tool. The window puts movements into the mailbox, and the tick
/// turns them into counts on a 1 µm grid before anything else sees them. The device renders no force (class
/// "shown"); motion slows down in proportion to the force shown, Δp = r(F) · Δp_hand (PseudoHaptics). The
/// screen keeps the drawn tool at the surface, with SceneOutput::p_WProxy. A grasper's jaw moves at the
/// requested speed, between closed and its stop. Stepped in the tick (age 0, device time = index · 1 ms).
/// Thread: mailbox() by the GUI, the rest as for IDevice.
class KeyboardMouseDevice final : public IDevice {
public:
    static constexpr double kGrid_m = 1e-6;
    static constexpr double kJawGrid_rad = 1e-4;

    /// Creates the device.
    /// Errors: badInput unless minimum < home < maximum on each axis, or if a ratio or force is out of range.
    static core::Result<std::unique_ptr<KeyboardMouseDevice>>
    create(const KeyboardMouseSettings& settings = {});

    PointerMailbox& mailbox() noexcept { return m_mailbox; }

    const DeviceDescriptor& descriptor() const noexcept override { return m_descriptor; }
    const IToolKinematics& kinematics() const noexcept override { return m_kinematics; }
    core::Result<void> open() override; ///< returns to home; earlier movements are discarded
    void close() noexcept override {}
    core::DeviceSample read(const realtime::HapticTick& now) noexcept override;
    void command(const realtime::HapticTick&, const ForceCommand&) noexcept override {}
    void show(const realtime::HapticTick&, const core::VisibleCues& cues) noexcept override;

private:
    KeyboardMouseDevice(const KeyboardMouseSettings& settings, DeviceDescriptor descriptor,
                        const CartesianKinematics& kinematics);

    KeyboardMouseSettings m_settings;
    DeviceDescriptor m_descriptor;
    CartesianKinematics m_kinematics;
    PointerMailbox m_mailbox;
    MotionIntake<4> m_intake;
    std::array<double, 3> m_position_m; ///< before rounding, so that slow movement is not lost
    double m_jaw_rad;
    double m_ratio = 1.0;
    std::uint32_t m_packet = 0;
};

} // namespace chiron::devices
