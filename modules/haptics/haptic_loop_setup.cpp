// SPDX-License-Identifier: GPL-3.0-or-later
// Construction and destruction of a loop. They allocate, so they are kept apart from the code that the tick
// calls.
#include "haptics/haptic_loop.h"

#include <vector>

namespace chiron::haptics {

core::Result<std::unique_ptr<HapticLoop>> HapticLoop::create(const HapticLoopParts& parts) {
    if (parts.tools.empty() || parts.tools.size() > static_cast<std::size_t>(core::kMaxTools))
        return core::fail(core::ErrorCode::badInput, "a loop needs 1 to " + std::to_string(core::kMaxTools) +
                                                         " tools, not " + std::to_string(parts.tools.size()));
    std::vector<SafetyTool> guarded;
    for (const LoopTool& tool : parts.tools)
        guarded.push_back({tool.device.descriptor(), tool.device.kinematics(), tool.mapping});
    CHIRON_TRY(parts.supervisor.configure(parts.safety, guarded));
    auto loop = std::unique_ptr<HapticLoop>(new HapticLoop(parts));
    if (loop->m_scene == nullptr)
        return core::fail(core::ErrorCode::badInput, "a loop needs a first scene, offered before it is made");
    return loop;
}

HapticLoop::HapticLoop(const HapticLoopParts& parts)
    : m_count(parts.tools.size()), m_inputs(parts.inputs), m_supervisor(parts.supervisor),
      m_scenes(parts.scenes), m_recorder(parts.recorder), m_scene(parts.scenes.take()) {
    for (std::size_t i = 0; i < m_count; ++i) {
        const LoopTool& tool = parts.tools[i];
        m_devices[i] = &tool.device;
        m_tools[i].map = devices::WorkspaceMap(tool.mapping);
        m_tools[i].friction = FrictionCompensation(tool.device.descriptor());
        m_tools[i].velocity =
            simulation::VelocityEstimator(static_cast<int>(tool.device.descriptor().axes.size()));
    }
}

HapticLoop::~HapticLoop() {
    if (m_scene != nullptr)
        m_scenes.retire(m_scene);
}

} // namespace chiron::haptics
