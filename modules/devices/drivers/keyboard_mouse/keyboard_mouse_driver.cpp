// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/keyboard_mouse/keyboard_mouse_driver.h"

#include "core/marked_texts.h"
#include "devices/drivers/endoscope_pointer/endoscope_pointer_device.h"
#include "devices/drivers/keyboard_mouse/keyboard_mouse_device.h"
#include "mechanisms/jaw.h"

#include <algorithm>

namespace chiron::devices {

namespace {
constexpr double kInside_m = 0.001; // from a tool's start position to the edge of its box
// Longer than the interval between a pointer's reports, and too short for anybody to notice.
constexpr double kFollowing_s = 0.025;

/// Makes a device whose box of W stays the same whatever the scale, so that the hand's range shrinks as the
/// scale grows.
template <class Device, class Settings>
core::Result<DriverTool> makePointer(Settings settings, double scale) {
    settings.following_s = kFollowing_s;
    for (std::size_t i = 0; i < 3; ++i) {
        settings.minimum_m[i] /= scale;
        settings.maximum_m[i] /= scale;
        settings.home_m[i] /= scale;
    }
    auto device = Device::create(settings);
    CHIRON_TRY(device);
    DriverTool tool;
    tool.input = &(*device)->mailbox();
    tool.device = std::move(*device);
    return tool;
}

/// Settings of a point tool: its range, and the jaw that its hand can close (0: none).
KeyboardMouseSettings pointSettings(double widestJaw_rad, const ToolRequest& tool) {
    KeyboardMouseSettings settings;
    settings.widestJaw_rad = widestJaw_rad;
    if (tool.startHeight_m)
        settings.home_m[2] = std::clamp(*tool.startHeight_m - tool.mapping.origin_m[2],
                                        settings.minimum_m[2] + kInside_m, settings.maximum_m[2] - kInside_m);
    return settings;
}

/// Settings of a grasper: the box that all graspers reach, as seen from each tool's own position. Each starts
/// under its entry point with its jaw open.
KeyboardMouseSettings grasperSettings(const WorkspaceMapping& mapping,
                                      const std::array<double, 3>& middle_m) {
    KeyboardMouseSettings settings;
    const double mirror = mapping.leftHanded ? -1.0 : 1.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double aside = (i == 0 ? mirror : 1.0) * (middle_m[i] - mapping.origin_m[i]);
        const double least = settings.minimum_m[i] + aside;
        const double most = settings.maximum_m[i] + aside;
        settings.home_m[i] = std::clamp(settings.home_m[i], least + kInside_m, most - kInside_m);
        settings.minimum_m[i] = least;
        settings.maximum_m[i] = most;
    }
    settings.widestJaw_rad = mechanisms::JawParameters{}.widest_rad;
    // An instrument that starts closed cannot grasp anything.
    settings.homeJaw_rad = settings.widestJaw_rad;
    return settings;
}

EndoscopePointerSettings endoscopeSettings(const core::Vec3& start_W) {
    EndoscopePointerSettings settings;
    settings.home_m = {start_W.x(), start_W.y(), start_W.z()};
    return settings;
}

core::Result<DriverTool> makeTool(const DriverRequest& request, const ToolRequest& tool) {
    switch (request.shape) {
    case ToolShape::endoscope:
        return makePointer<EndoscopePointerDevice>(endoscopeSettings(request.endoscopeStart_W),
                                                   request.scale);
    case ToolShape::grasper:
        return makePointer<KeyboardMouseDevice>(grasperSettings(tool.mapping, request.middle_m),
                                                request.scale);
    case ToolShape::point:
        break;
    }
    return makePointer<KeyboardMouseDevice>(pointSettings(request.widestJaw_rad, tool), request.scale);
}

core::Result<std::vector<DriverTool>> openPointers(DriverRequest request) {
    std::vector<DriverTool> made;
    for (const ToolRequest& asked : request.tools) {
        auto tool = makeTool(request, asked);
        CHIRON_TRY(tool);
        made.push_back(std::move(*tool));
    }
    return made;
}

/// A window always has a mouse or a keyboard; without a window it is not possible to determine which.
std::vector<FoundDevice> discoverPointer() {
    return {{"mouse and keyboard", {}}};
}

constexpr KinematicsEntry kPointerKinematics[]{
    {"cartesian", makeKinematicsOf<CartesianKinematics>},
    {EndoscopePoseKinematics::kId, makeKinematicsOf<EndoscopePoseKinematics>},
};
} // namespace

const Driver kKeyboardMouseDriver{
    .id = "keyboard_mouse",
    .title = "Mouse and keyboard: force is shown, not felt",
    .needs = "a pointer or a keyboard, and a screen",
    .planWord = "mouse",
    .deviceClass = DeviceClass::shown,
    .movedBy = MovedBy::person,
    .kinematics = kPointerKinematics,
    .discover = discoverPointer,
    .open = openPointers,
    .name = QT_TRANSLATE_NOOP("Drivers", "Mouse and keyboard"),
    .readiness = QT_TRANSLATE_NOOP("Drivers", "Ready. Moves the tool with a pointer or with keys."),
    .hand = HandKind::mouseAndKeyboard,
};

} // namespace chiron::devices
