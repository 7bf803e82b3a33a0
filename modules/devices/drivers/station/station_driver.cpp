// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/station/station_driver.h"

#include "core/marked_texts.h"
#include "devices/drivers/cartesian/cartesian_kinematics.h"
#include "devices/drivers/station/hid_transport.h"
#include "devices/drivers/station/station_tool.h"

#include <utility>

namespace chiron::devices {

namespace {

/// A station on a network or a serial line is not looked for: a question to a device of somebody else could
/// move it. On USB a device says what it is without being asked.
std::vector<FoundDevice> discoverStations() {
    std::vector<FoundDevice> found;
    for (FoundStation& each : findHidStations())
        found.push_back({std::move(each.model), std::move(each.serialNumber), std::move(each.address)});
    return found;
}

/// Whether any axis turns the tool.
bool turns(const StationTool& tool) {
    const core::DeviceSample sample;
    for (std::size_t axis = 0; axis < tool.descriptor().axes.size(); ++axis) {
        AxisValues rates{};
        rates[axis] = 1.0 / tool.descriptor().axes[axis].resolution;
        core::Vec3 v_DT = core::Vec3::Zero(), w_DT = core::Vec3::Zero();
        tool.kinematics().velocity(sample, rates, v_DT, w_DT);
        if (w_DT.norm() > 0.1) // rad per rad
            return true;
    }
    return false;
}

core::Result<void> checkShape(const StationTool& tool, ToolShape shape, const std::string& where) {
    if (shape == ToolShape::grasper && tool.descriptor().jawResolution_rad <= 0.0)
        return core::fail(core::ErrorCode::wrongUse,
                          "station at " + where + ": it has no jaw, and this exercise is done with graspers");
    if (shape == ToolShape::endoscope && !turns(tool))
        return core::fail(core::ErrorCode::wrongUse,
                          "station at " + where +
                              ": its tool cannot be turned, and this exercise is done with an endoscope");
    return {};
}

core::Result<std::vector<DriverTool>> openStations(DriverRequest request) {
    if (!(request.scale >= 0.25 && request.scale <= 4.0))
        return core::fail(core::ErrorCode::badInput, "station: a workspace scale of " +
                                                         std::to_string(request.scale) +
                                                         "; expected 0.25 to 4");
    for (std::size_t i = 0; i < request.tools.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (!request.tools[i].address.empty() && request.tools[i].address == request.tools[j].address)
                return core::fail(core::ErrorCode::badInput, "station: two tools at " +
                                                                 request.tools[i].address +
                                                                 "; each needs a station of its own");
    std::vector<DriverTool> made;
    for (const ToolRequest& asked : request.tools) {
        if (asked.address.empty()) {
            made.push_back({.device = StationTool::absent()});
            continue;
        }
        const auto address = readStationAddress(asked.address);
        CHIRON_TRY(address);
        auto tool =
            StationTool::create({*address, asked.address, asked.mapping, request.frictionCompensation});
        CHIRON_TRY(tool);
        CHIRON_TRY(checkShape(**tool, request.shape, asked.address));
        made.push_back({.device = std::move(*tool)});
    }
    return made;
}

/// Its own; a station may have any of the catalogue's.
constexpr KinematicsEntry kStationKinematics[]{{"cartesian", makeKinematicsOf<CartesianKinematics>}};

} // namespace

const Driver kStationDriver{
    .id = "station",
    .title = "Haptic station: force is felt, over USB, a network or a serial line",
    .needs = "a station that speaks the station protocol, on USB or at an address (train --address); tested "
             "against an emulation, never met hardware",
    .planWord = "station",
    .deviceClass = DeviceClass::felt,
    .movedBy = MovedBy::person,
    .kinematics = kStationKinematics,
    .discover = discoverStations,
    .open = openStations,
    .name = QT_TRANSLATE_NOOP("Drivers", "Haptic device (USB, network or serial line)"),
    .readiness = QT_TRANSLATE_NOOP(
        "Drivers", "Its forces are felt. Plug it in by USB, or give its address on the command line (see "
                   "chiron-cli train --help). Tested against an emulation; it never met hardware."),
};

} // namespace chiron::devices
