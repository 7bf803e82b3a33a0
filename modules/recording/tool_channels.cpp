// SPDX-License-Identifier: GPL-3.0-or-later
// The channels that this program writes for a session.
#include "core/haptic_frame.h"
#include "recording/channel_table.h"
#include "recording/wrench_rounding.h"

#include <algorithm>
#include <array>

namespace chiron::recording {

namespace {
constexpr std::int64_t kTick_ns = 1'000'000; // grid around which now_ns jitters

Channel lossless(std::uint8_t tool, std::string id, std::string unit = "1", double resolution = 1.0) {
    Channel c;
    c.tool = tool;
    c.id = std::move(id);
    c.unit = std::move(unit);
    c.resolution = resolution;
    return c;
}

Channel quantised(std::uint8_t tool, std::string id, std::string unit, double resolution, std::string frame) {
    Channel c = lossless(tool, std::move(id), std::move(unit), resolution);
    c.frame = std::move(frame);
    c.kind = ChannelKind::quantised;
    return c;
}

Channel referring(Channel c, std::size_t reference, std::int64_t factor) {
    c.reference = static_cast<int>(reference);
    c.factor = factor;
    return c;
}

void addHeader(std::vector<Channel>& out) {
    out.push_back(lossless(kNoTool, "tick"));
    out.push_back(referring(lossless(kNoTool, "now", "ns"), 0, kTick_ns));
    for (const char* id : {"events", "guards", "trial"})
        out.push_back(lossless(kNoTool, id));
    out.push_back(lossless(kNoTool, "heartbeat_age", "ms"));
    for (const char* id : {"phase", "force_state", "paused", "command_0_kind", "command_0_argument",
                           "command_1_kind", "command_1_argument"})
        out.push_back(lossless(kNoTool, id));
}

void addWrench(std::vector<Channel>& out, std::uint8_t tool, const std::string& name,
               std::optional<std::size_t> reference) {
    static constexpr std::array<const char*, 6> kParts = {".fx", ".fy", ".fz", ".tx", ".ty", ".tz"};
    for (std::size_t i = 0; i < kParts.size(); ++i) {
        Channel c = i < 3 ? quantised(tool, name + kParts[i], "N", kForceResolution_N, "W")
                          : quantised(tool, name + kParts[i], "N*m", kTorqueResolution_Nm, "W");
        out.push_back(reference ? referring(std::move(c), *reference + i, 1) : std::move(c));
    }
}

void addToolChannels(std::vector<Channel>& out, std::uint8_t tool, const ToolChannels& info) {
    for (std::size_t i = 0; i < info.axes.size(); ++i) {
        Channel c = lossless(tool, "axis." + info.axes[i].id, info.axes[i].unit, info.axes[i].resolution);
        c.frame = "D";
        c.slot = static_cast<std::uint8_t>(i);
        out.push_back(std::move(c));
    }
    out.push_back(lossless(tool, "jaw", "rad", info.jawResolution_rad > 0.0 ? info.jawResolution_rad : 1.0));
    out.push_back(lossless(tool, "buttons"));
    const std::size_t packet = out.size();
    out.push_back(lossless(tool, "packet"));
    out.push_back(lossless(tool, "status"));
    out.push_back(referring(lossless(tool, "device_time", "us"), packet, info.period_us));
    out.push_back(lossless(tool, "age", "us"));
    const std::size_t tissue = out.size();
    addWrench(out, tool, "tissue", std::nullopt);
    addWrench(out, tool, "commanded", tissue);
    addWrench(out, tool, "measured", tissue); // a device follows the requested force
    out.push_back(quantised(tool, "display.normal_force", "N", kForceResolution_N, ""));
    out.push_back(quantised(tool, "display.pitch", "rad", kAngleResolution_rad, ""));
    out.push_back(quantised(tool, "display.roll", "rad", kAngleResolution_rad, ""));
}

bool isIdentifier(const std::string& id) {
    return !id.empty() && std::all_of(id.begin(), id.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    });
}

core::Result<void> addScene(std::vector<Channel>& out, const SceneChannels& scene) {
    if (scene.quantities.size() > core::kMaxQuantities)
        return core::fail(core::ErrorCode::wrongUse, "recording: " + std::to_string(scene.quantities.size()) +
                                                         " quantities, expected at most " +
                                                         std::to_string(core::kMaxQuantities));
    for (std::size_t i = 0; i < scene.quantities.size(); ++i) {
        const core::QuantityDescription& quantity = scene.quantities[i];
        if (!isIdentifier(quantity.id)) // the id becomes the name of a column in trace files
            return core::fail(core::ErrorCode::wrongUse, "recording: quantity " + std::to_string(i) + " \"" +
                                                             quantity.id +
                                                             "\": expected letters, digits and _");
        out.push_back(quantised(kNoTool, "quantity." + quantity.id, quantity.unit, quantity.resolution, ""));
        out.back().slot = static_cast<std::uint8_t>(i);
    }
    if (scene.energy)
        for (const char* id : {"energy.supplied", "energy.stored"})
            out.push_back(quantised(kNoTool, id, "J", kEnergyResolution_J, ""));
    return {};
}
} // namespace

core::Result<ChannelTable> ChannelTable::forTools(std::span<const ToolChannels> tools,
                                                  const SceneChannels& scene) {
    if (tools.empty() || tools.size() > core::kMaxTools)
        return core::fail(core::ErrorCode::wrongUse, "recording: " + std::to_string(tools.size()) +
                                                         " tools, expected 1.." +
                                                         std::to_string(core::kMaxTools));
    std::vector<Channel> channels;
    addHeader(channels);
    for (std::size_t t = 0; t < tools.size(); ++t) {
        if (tools[t].axes.empty() || tools[t].axes.size() > core::kMaxCoordinates)
            return core::fail(core::ErrorCode::wrongUse, "recording: tool " + std::to_string(t) + " has " +
                                                             std::to_string(tools[t].axes.size()) +
                                                             " axes, expected 1.." +
                                                             std::to_string(core::kMaxCoordinates));
        addToolChannels(channels, static_cast<std::uint8_t>(t), tools[t]);
    }
    CHIRON_TRY(addScene(channels, scene));
    return fromChannels(std::move(channels));
}

} // namespace chiron::recording
