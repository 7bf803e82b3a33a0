// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quantity.h"
#include "core/result.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::recording {

/// Describes one coordinate of a tool to the recording (taken from devices::AxisDescriptor, which this module
/// may not link).
struct AxisChannel {
    std::string id;          ///< e.g. "heading"
    std::string unit;        ///< "m" or "rad"
    double resolution = 0.0; ///< unit per count
};

/// Describes one tool to the recording.
struct ToolChannels {
    std::vector<AxisChannel> axes; ///< 1..kMaxCoordinates, in the order of ToolFrame::counts
    double jawResolution_rad = 0.0;
    /// Declared time between packets: predicts the device time from the packet number.
    std::uint32_t period_us = 1000;
};

/// The channels of the scene that are recorded in addition to the tools.
struct SceneChannels {
    /// In the order of TickHeader::quantities; at most core::kMaxQuantities.
    std::vector<core::QuantityDescription> quantities;
    /// The passivity observer's energy balance: "energy.supplied" and "energy.stored", at
    /// kEnergyResolution_J.
    bool energy = false;
};

enum class ChannelKind : std::uint8_t { lossless = 0, quantised = 1 };

inline constexpr std::uint8_t kNoTool = 255; ///< a channel of the tick header
inline constexpr int kNoReference = -1;

/// One column of every chunk.
struct Channel {
    std::uint8_t tool = kNoTool;
    std::string id;          ///< unique within its tool, e.g. "tick", "axis.heading", "tissue.fz"
    std::string unit;        ///< "1", "m", "rad", "N", "N*m", "ns", "us", "ms"
    double resolution = 1.0; ///< unit per count
    /// Frame in which the value is expressed ("W", "D"); empty if it has none.
    std::string frame;
    ChannelKind kind = ChannelKind::lossless;
    /// Coordinate number of an "axis." channel, index of a "quantity." channel in the header.
    std::uint8_t slot = 0;
    /// Index of an earlier channel: a column may hold value − factor · value of that channel.
    int reference = kNoReference;
    std::int64_t factor = 0;
};

/// The description at the start of a recording. Readers find channels by (tool, id), never by position, and
/// skip those that they do not know. Copyable; immutable after construction.
class ChannelTable {
public:
    static constexpr std::size_t kMaximumChannels = 512;
    static constexpr std::size_t kMaximumBytes = 64 * 1024;

    /// Returns the table that this program writes for the given tools (1..kMaxTools) and scene. The channels
    /// "quantity.<id>", which belong to no tool and have their own resolutions, follow those of the tools.
    /// Errors: wrongUse naming the tool or quantity.
    static core::Result<ChannelTable> forTools(std::span<const ToolChannels> tools,
                                               const SceneChannels& scene = {});
    /// Makes a table of any list of channels after checking it (unique ids, finite positive resolutions,
    /// references).
    /// Errors: badInput.
    static core::Result<ChannelTable> fromChannels(std::vector<Channel> channels);
    /// Decodes a table.
    /// Errors: badInput naming the byte offset, what was found and what was expected.
    static core::Result<ChannelTable> decode(std::span<const std::uint8_t> bytes);
    std::vector<std::uint8_t> encode() const;

    const std::vector<Channel>& channels() const noexcept { return m_channels; }
    int tools() const noexcept { return m_tools; } ///< highest tool number + 1
    std::optional<std::size_t> find(std::uint8_t tool, std::string_view id) const noexcept;

private:
    explicit ChannelTable(std::vector<Channel> channels);
    std::vector<Channel> m_channels;
    int m_tools = 0;
};

} // namespace chiron::recording
