// SPDX-License-Identifier: GPL-3.0-or-later
// Set-up of the driver, kept apart from the code that the tick calls.
#include "devices/drivers/keyboard_mouse/keyboard_mouse_device.h"

#include "devices/drivers/keyboard_mouse/pointer_setup.h"

namespace chiron::devices {

namespace {

core::Result<void> check(const KeyboardMouseSettings& s) {
    for (std::size_t i = 0; i < 3; ++i) {
        const bool ordered = s.minimum_m[i] < s.home_m[i] && s.home_m[i] < s.maximum_m[i];
        const bool small =
            s.minimum_m[i] >= -1.0 && s.maximum_m[i] <= 1.0; // 1 m: counts stay far inside 32 bits
        if (!ordered || !small)
            return core::fail(core::ErrorCode::badInput,
                              std::string("keyboard_mouse: workspace of axis ") + "xyz"[i] +
                                  " must satisfy -1 m <= minimum < home < maximum <= 1 m");
    }
    if (!(s.homeJaw_rad >= 0.0 && s.homeJaw_rad <= s.widestJaw_rad && s.widestJaw_rad <= 1.6))
        return core::fail(core::ErrorCode::badInput,
                          "keyboard_mouse: the jaw must satisfy 0 <= home <= widest <= 1.6 rad");
    return checkPointer("keyboard_mouse", s.pseudoHaptics, s.following_s);
}

DeviceDescriptor describe(const KeyboardMouseSettings& s) {
    DeviceDescriptor d;
    d.driver = "keyboard_mouse";
    d.model = s.widestJaw_rad > 0.0 ? "Mouse and keyboard, moving a grasper" : "Mouse and keyboard";
    d.kinematics = "cartesian";
    for (std::size_t i = 0; i < 3; ++i)
        d.axes.push_back({.id = std::string(1, "xyz"[i]),
                          .unit = AxisUnit::metre,
                          .resolution = KeyboardMouseDevice::kGrid_m,
                          .minimum = s.minimum_m[i],
                          .maximum = s.maximum_m[i]});
    d.jawResolution_rad = s.widestJaw_rad > 0.0 ? KeyboardMouseDevice::kJawGrid_rad : 0.0;
    d.inProcess = true;
    d.period_us = 1000;
    return d;
}

} // namespace

core::Result<std::unique_ptr<KeyboardMouseDevice>>
KeyboardMouseDevice::create(const KeyboardMouseSettings& settings) {
    CHIRON_TRY(check(settings));
    DeviceDescriptor descriptor = describe(settings);
    auto kinematics = CartesianKinematics::create(descriptor);
    CHIRON_TRY(kinematics);
    return std::unique_ptr<KeyboardMouseDevice>(
        new KeyboardMouseDevice(settings, std::move(descriptor), *kinematics));
}

KeyboardMouseDevice::KeyboardMouseDevice(const KeyboardMouseSettings& settings, DeviceDescriptor descriptor,
                                         const CartesianKinematics& kinematics)
    : m_settings(settings), m_descriptor(std::move(descriptor)), m_kinematics(kinematics),
      m_intake(followingShare(settings.following_s)), m_position_m(settings.home_m),
      m_jaw_rad(settings.homeJaw_rad) {}

core::Result<void> KeyboardMouseDevice::open() {
    m_intake.forget(m_mailbox.read());
    m_position_m = m_settings.home_m;
    m_jaw_rad = m_settings.homeJaw_rad;
    m_ratio = 1.0;
    return {};
}

} // namespace chiron::devices
