// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/driver.h"
#include "mechanisms/scripted_motion.h"

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace chiron::tests {

/// A request that any driver can serve: one point, and whatever may move it, which moves by a few
/// millimetres.
inline devices::DriverRequest requestForAnyDriver(std::string_view mechanism) {
    devices::DriverRequest request;
    request.mechanism = std::string(mechanism);
    request.endoscopeStart_W = {0.0, -0.069, 0.0};
    devices::ToolRequest tool;
    // A five-bar mechanism begins where an endoscope does.
    const core::Vec3 start =
        mechanism == "five_bar_spherical" ? request.endoscopeStart_W : devices::kHeldFrom_D;
    tool.strategy = std::make_unique<mechanisms::ScriptedMotion>(
        start, std::vector<mechanisms::ScriptedMotion::Term>{{core::Vec3(0.002, 0.003, 0.001), 0.5, 0.0}});
    tool.trace = {{0.0, {0.0, 0.0, 0.05}}, {1.0, {0.01, 0.0, 0.05}}};
    request.tools.push_back(std::move(tool));
    return request;
}

} // namespace chiron::tests
