// SPDX-License-Identifier: GPL-3.0-or-later
// Set-up of the driver, kept apart from the code that the tick calls.
#include "devices/drivers/endoscope_pointer/endoscope_pointer_device.h"

#include "devices/axis_resolutions_setup.h"
#include "devices/drivers/keyboard_mouse/pointer_setup.h"

#include <string>
#include <utility>

namespace chiron::devices {

namespace {

constexpr double kWidestYaw_rad = 1.3962634015954636; // 80°: the angles are singular at 90°
constexpr const char* kAxisNames[EndoscopePoseKinematics::kAxes] = {"x", "y", "z", "pitch", "yaw", "roll"};

core::Result<void> check(const EndoscopePointerSettings& s) {
    for (std::size_t i = 0; i < 3; ++i) {
        const bool along = s.minimum_m[i] < s.home_m[i] && s.home_m[i] < s.maximum_m[i] &&
                           s.minimum_m[i] >= -1.0 &&
                           s.maximum_m[i] <= 1.0; // 1 m: counts stay far inside 32 bits
        if (!along)
            return core::fail(core::ErrorCode::badInput,
                              std::string("endoscope_pointer: workspace of axis ") + kAxisNames[i] +
                                  " must satisfy -1 m <= minimum < home < maximum <= 1 m");
        const double widest = i == 1 ? kWidestYaw_rad : 6.3;
        const bool about = s.minimum_rad[i] < s.home_rad[i] && s.home_rad[i] < s.maximum_rad[i] &&
                           s.minimum_rad[i] >= -widest && s.maximum_rad[i] <= widest;
        if (!about)
            return core::fail(core::ErrorCode::badInput,
                              std::string("endoscope_pointer: travel of axis ") + kAxisNames[i + 3] +
                                  " must satisfy minimum < home < maximum, at most a turn either "
                                  "way, 80 degrees for yaw");
    }
    return checkPointer("endoscope_pointer", s.pseudoHaptics, s.following_s);
}

DeviceDescriptor describe(const EndoscopePointerSettings& s) {
    DeviceDescriptor d;
    d.driver = "keyboard_mouse";
    d.model = "Mouse and keyboard, moving an endoscope";
    d.kinematics = EndoscopePoseKinematics::kId;
    for (std::size_t i = 0; i < EndoscopePoseKinematics::kAxes; ++i) {
        const bool length = i < 3;
        d.axes.push_back(
            {.id = kAxisNames[i],
             .unit = length ? AxisUnit::metre : AxisUnit::radian,
             .resolution = length ? EndoscopePointerDevice::kGrid_m : EndoscopePointerDevice::kGrid_rad,
             .minimum = length ? s.minimum_m[i] : s.minimum_rad[i - 3],
             .maximum = length ? s.maximum_m[i] : s.maximum_rad[i - 3]});
    }
    d.inProcess = true;
    d.period_us = 1000;
    return d;
}

} // namespace

core::Result<EndoscopePoseKinematics> EndoscopePoseKinematics::create(const DeviceDescriptor& descriptor) {
    const auto resolution = axisResolutions<kAxes>(descriptor, kId, "x, y, z, pitch, yaw, roll");
    CHIRON_TRY(resolution);
    for (std::size_t i = 0; i < kAxes; ++i)
        if (descriptor.axes[i].unit != (i < 3 ? AxisUnit::metre : AxisUnit::radian))
            return kinematicsMisfit(kId, "axes[" + std::to_string(i) + "] must be in " +
                                             (i < 3 ? "metres" : "radians"));
    return EndoscopePoseKinematics(*resolution);
}

EndoscopePoseKinematics::~EndoscopePoseKinematics() = default;

core::Result<std::unique_ptr<EndoscopePointerDevice>>
EndoscopePointerDevice::create(const EndoscopePointerSettings& settings) {
    CHIRON_TRY(check(settings));
    DeviceDescriptor descriptor = describe(settings);
    auto kinematics = EndoscopePoseKinematics::create(descriptor);
    CHIRON_TRY(kinematics);
    return std::unique_ptr<EndoscopePointerDevice>(
        new EndoscopePointerDevice(settings, std::move(descriptor), *kinematics));
}

EndoscopePointerDevice::EndoscopePointerDevice(const EndoscopePointerSettings& settings,
                                               DeviceDescriptor descriptor,
                                               const EndoscopePoseKinematics& kinematics)
    : m_settings(settings), m_descriptor(std::move(descriptor)), m_kinematics(kinematics),
      m_intake(followingShare(settings.following_s)),
      m_position_m(settings.home_m[0], settings.home_m[1], settings.home_m[2]),
      m_angles_rad(settings.home_rad[0], settings.home_rad[1], settings.home_rad[2]) {}

core::Result<void> EndoscopePointerDevice::open() {
    m_intake.forget(m_mailbox.read());
    m_position_m = {m_settings.home_m[0], m_settings.home_m[1], m_settings.home_m[2]};
    m_angles_rad = {m_settings.home_rad[0], m_settings.home_rad[1], m_settings.home_rad[2]};
    m_ratio = 1.0;
    return {};
}

} // namespace chiron::devices
