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

/// What the recording must know of one coordinate of a tool (from devices::AxisDescriptor, which it may not
/// link).
struct AxisChannel {
    std::string id;          ///< e.g. "heading"
    std::string unit;        ///< "m" or "rad"
    double resolution = 0.0; ///< unit a count
};

/// What the recording must know of one tool.
struct ToolChannels {
    std::vector<AxisChannel> axes; ///< 1..kMaxCoordinates, in the order of ToolFrame::counts
    double jawResolution_rad = 0.0;
    std::uint32_t period_us =
        1000; ///< declared time between packets: predicts device time from the packet number
};

/// What the recording holds of the scene beside the tools.
struct SceneChannels {
    std::vector<core::QuantityDescription> quantities; ///< in the order of TickHeader::quantities; at most core::kMaxQuantities
    bool energy = false; ///< the passivity books: "energy.supplied" and "energy.stored", at kEnergyResolution_J
};

enum class ChannelKind : std::uint8_t { lossless = 0, quantised = 1 };

inline constexpr std::uint8_t kNoTool = 255; ///< a channel of the tick header
inline constexpr int kNoReference = -1;

/// One column of every chunk.
struct Channel {
    std::uint8_t tool = kNoTool;
    std::string id;          ///< unique within its tool, e.g. "tick", "axis.heading", "tissue.fz"
    std::string unit;        ///< "1", "m", "rad", "N", "N*m", "ns", "us", "ms"
    double resolution = 1.0; ///< unit a count
    std::string frame;       ///< frame that the value is expressed in ("W", "D"), empty if it has none
    ChannelKind kind = ChannelKind::lossless;
    std::uint8_t slot = 0;        ///< coordinate number of an "axis." channel, place of a "quantity." one in the header
    int reference = kNoReference; ///< a column may hold value − factor · value of this earlier channel
    std::int64_t factor = 0;
};

/// The description that opens a recording. Readers find channels by (tool, id), never by position, and skip
/// the ones they do not know. Copyable; immutable after it is made.
class ChannelTable {
public:
    static constexpr std::size_t kMaximumChannels = 512;
    static constexpr std::size_t kMaximumBytes = 64 * 1024;

    /// The table that this program writes for the given tools (1..kMaxTools) and scene: channels without a tool,
    /// "quantity.<id>" each at its resolution, after all the others. Error: wrongUse naming the tool or quantity.
    static core::Result<ChannelTable> forTools(std::span<const ToolChannels> tools, const SceneChannels& scene = {});
    /// Any list of channels, checked (unique ids, finite positive resolutions, references). Error: badInput.
    static core::Result<ChannelTable> fromChannels(std::vector<Channel> channels);
    /// Error: badInput naming the byte offset, what was found and what was expected.
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
