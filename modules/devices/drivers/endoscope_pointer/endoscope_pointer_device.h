// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device.h"
#include "devices/api/endoscope_mailbox.h"
#include "devices/drivers/endoscope_pointer/endoscope_pose_kinematics.h"
#include "devices/drivers/keyboard_mouse/motion_intake.h"

#include <memory>

namespace chiron::devices {

/// Range in which an endoscope can be moved with a mouse and a keyboard: at least that of P1's mechanism.
/// Angles rad, lengths m, D.
struct EndoscopePointerSettings {
    std::array<double, 3> minimum_m{-0.015, -0.085, -0.040};
    std::array<double, 3> maximum_m{0.015, 0.105, 0.185};
    std::array<double, 3> home_m{0.0, -0.069, 0.0};
    /// Pitch, yaw, roll.
    std::array<double, 3> minimum_rad{-0.523598775598299, -0.523598775598299, -3.141592653589793};
    /// The centre-line's 66.3° + 30°.
    std::array<double, 3> maximum_rad{1.680752, 0.523598775598299, 3.141592653589793};
    std::array<double, 3> home_rad{0.0, 0.0, 0.0};
    /// True: the tip stays in the plane of symmetry (x = its home), as on P1's mechanism. False: it moves
    /// freely along the viewing direction.
    bool planar = true;
    double following_s = 0.0; ///< as KeyboardMouseSettings
    PseudoHaptics pseudoHaptics{};
};

/// An endoscope moved by a mouse and a keyboard: an input-only tool (class "shown"). The window states how
/// the picture is to move (EndoscopeMovement); each tick integrates this in the tool's own frame,
///   Δp = r(F) · advance · a + right · x_T + up · y_T,
///   (pitch˙, yaw˙, roll˙) = J_ω⁻¹ R_DT (turnUp, −turnRight, −spin),
/// so that the endoscope moves along its viewing direction. The result is quantised to 1 µm and 10 µrad
/// before anything else sees it. r(F) (PseudoHaptics) slows the movement along the axis, where an endoscope
/// meets its resistance. Stepped in the tick (age 0, device time = index · 1 ms).
/// Thread: mailbox() by the GUI, the rest as for IDevice.
class EndoscopePointerDevice final : public IDevice {
public:
    static constexpr double kGrid_m = 1e-6;
    static constexpr double kGrid_rad = 1e-5;

    /// Creates the device.
    /// Errors: badInput unless minimum < home < maximum on each axis and yaw stays within ±80°, or if a ratio
    /// is out of range.
    static core::Result<std::unique_ptr<EndoscopePointerDevice>>
    create(const EndoscopePointerSettings& settings = {});

    EndoscopeMailbox& mailbox() noexcept { return m_mailbox; }

    const DeviceDescriptor& descriptor() const noexcept override { return m_descriptor; }
    const IToolKinematics& kinematics() const noexcept override { return m_kinematics; }
    core::Result<void> open() override; ///< returns to home; earlier movements are discarded
    void close() noexcept override {}
    core::DeviceSample read(const realtime::HapticTick& now) noexcept override;
    void command(const realtime::HapticTick&, const ForceCommand&) noexcept override {}
    void show(const realtime::HapticTick&, const core::VisibleCues& cues) noexcept override;

private:
    EndoscopePointerDevice(const EndoscopePointerSettings& settings, DeviceDescriptor descriptor,
                           const EndoscopePoseKinematics& kinematics);
    void move(const EndoscopeMovement& hand) noexcept;

    EndoscopePointerSettings m_settings;
    DeviceDescriptor m_descriptor;
    EndoscopePoseKinematics m_kinematics;
    EndoscopeMailbox m_mailbox;
    MotionIntake<6> m_intake;
    core::Vec3 m_position_m; ///< before rounding, so that slow movement is not lost
    core::Vec3 m_angles_rad; ///< pitch, yaw, roll
    double m_ratio = 1.0;
    std::uint32_t m_packet = 0;
};

} // namespace chiron::devices
