// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/replay/replay_driver.h"

#include "core/marked_texts.h"
#include "devices/drivers/replay/replay_device.h"

namespace chiron::devices {

namespace {
core::Result<std::vector<DriverTool>> openTraces(DriverRequest request) {
    std::vector<DriverTool> made;
    for (std::size_t i = 0; i < request.tools.size(); ++i) {
        auto device = ReplayDevice::create(request.tools[i].trace);
        if (!device) {
            const std::string which =
                request.tools.size() > 1 ? "tool " + std::to_string(i) + ": " : std::string();
            return core::fail(device.error().code, which + device.error().message);
        }
        made.push_back({std::move(*device)});
    }
    return made;
}

std::vector<FoundDevice> discoverTraces() {
    return {{"recorded trace", {}}};
}

constexpr KinematicsEntry kTraceKinematics[]{{"cartesian", makeKinematicsOf<CartesianKinematics>}};
} // namespace

const Driver kReplayDriver{
    .id = "replay",
    .title = "Recorded trace",
    .needs = "a trace file",
    .planWord = "trace",
    .deviceClass = DeviceClass::shown,
    .movedBy = MovedBy::recording,
    .kinematics = kTraceKinematics,
    .discover = discoverTraces,
    .open = openTraces,
    .name = QT_TRANSLATE_NOOP("Drivers", "Recorded trace"),
    .readiness = QT_TRANSLATE_NOOP("Drivers", "Ready. Plays a trace file as if a hand moved the device."),
};

} // namespace chiron::devices
