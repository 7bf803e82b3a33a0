// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/channel_table.h"

#include "core/haptic_frame.h"
#include "recording/byte_cursor.h"
#include "recording/wrench_rounding.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace chiron::recording {

namespace {
constexpr std::uint32_t kTableMagic = 0x54434843; // "CHCT"
constexpr std::uint16_t kTableVersion = 1;
constexpr std::size_t kMaximumText = 64;

std::string place(std::size_t offset) {
    return "channel table, byte " + std::to_string(offset) + ": ";
}

/// Returns what is wrong with a channel, or nothing; `index` is its position in the list.
std::optional<std::string> flawOf(const Channel& c, std::size_t index, const std::vector<Channel>& all) {
    if (c.tool != kNoTool && c.tool >= core::kMaxTools)
        return "tool " + std::to_string(c.tool) + ", expected 0.." + std::to_string(core::kMaxTools - 1) +
               " or 255";
    if (c.id.empty() || c.id.size() > kMaximumText || c.unit.size() > kMaximumText ||
        c.frame.size() > kMaximumText)
        return "an id, unit or frame of a wrong length, expected 1.." + std::to_string(kMaximumText) +
               " bytes";
    if (!std::isfinite(c.resolution) || !(c.resolution > 0.0))
        return "a resolution that is not positive and finite, expected a number above 0";
    if (c.kind != ChannelKind::lossless && c.kind != ChannelKind::quantised)
        return "kind " + std::to_string(static_cast<int>(c.kind)) + ", expected 0 or 1";
    if (c.reference == kNoReference)
        return std::nullopt;
    if (c.reference < 0 || static_cast<std::size_t>(c.reference) >= index)
        return "reference " + std::to_string(c.reference) + ", expected an earlier channel";
    if (all[static_cast<std::size_t>(c.reference)].reference != kNoReference)
        return "a reference to a channel that has one itself, expected one that stands alone";
    return std::nullopt;
}

void appendChannel(std::vector<std::uint8_t>& out, const Channel& c) {
    out.push_back(c.tool);
    appendText(out, c.id);
    appendText(out, c.unit);
    appendWord(out, std::bit_cast<std::uint64_t>(c.resolution));
    appendText(out, c.frame);
    out.push_back(static_cast<std::uint8_t>(c.kind));
    out.push_back(c.slot);
    appendWord(out, static_cast<std::uint16_t>(c.reference + 1));
    appendVarint(out, zigZag(static_cast<std::uint64_t>(c.factor)));
}

std::optional<Channel> readChannel(ByteCursor& in) {
    const auto tool = in.word<std::uint8_t>();
    auto id = in.text(kMaximumText);
    auto unit = in.text(kMaximumText);
    const auto resolution = in.word<std::uint64_t>();
    auto frame = in.text(kMaximumText);
    const auto kind = in.word<std::uint8_t>();
    const auto slot = in.word<std::uint8_t>();
    const auto reference = in.word<std::uint16_t>();
    const auto factor = in.varint();
    if (!tool || !id || !unit || !resolution || !frame || !kind || !slot || !reference || !factor)
        return std::nullopt;
    Channel c;
    c.tool = *tool;
    c.id = std::move(*id);
    c.unit = std::move(*unit);
    c.resolution = std::bit_cast<double>(*resolution);
    c.frame = std::move(*frame);
    c.kind = static_cast<ChannelKind>(*kind);
    c.slot = *slot;
    c.reference = static_cast<int>(*reference) - 1;
    c.factor = static_cast<std::int64_t>(unZigZag(*factor));
    return c;
}
} // namespace

ChannelTable::ChannelTable(std::vector<Channel> channels) : m_channels(std::move(channels)) {
    for (const Channel& c : m_channels)
        if (c.tool != kNoTool)
            m_tools = std::max(m_tools, c.tool + 1);
}

core::Result<ChannelTable> ChannelTable::fromChannels(std::vector<Channel> channels) {
    if (channels.empty() || channels.size() > kMaximumChannels)
        return core::fail(core::ErrorCode::badInput, "channel table: " + std::to_string(channels.size()) +
                                                         " channels, expected 1.." +
                                                         std::to_string(kMaximumChannels));
    std::set<std::pair<std::uint8_t, std::string_view>> seen;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        auto flaw = flawOf(channels[i], i, channels);
        if (!flaw && !seen.emplace(channels[i].tool, channels[i].id).second)
            flaw = "an id that its tool has already, expected each once";
        if (flaw)
            return core::fail(core::ErrorCode::badInput, "channel table: channel " + std::to_string(i) +
                                                             " \"" + channels[i].id + "\": found " + *flaw);
    }
    ChannelTable table(std::move(channels));
    if (table.encode().size() > kMaximumBytes)
        return core::fail(core::ErrorCode::badInput,
                          "channel table: more than " + std::to_string(kMaximumBytes) + " bytes");
    return table;
}

std::vector<std::uint8_t> ChannelTable::encode() const {
    std::vector<std::uint8_t> out;
    appendWord(out, kTableMagic);
    appendWord(out, kTableVersion);
    appendWord(out, static_cast<std::uint16_t>(m_channels.size()));
    for (const Channel& c : m_channels)
        appendChannel(out, c);
    return out;
}

core::Result<ChannelTable> ChannelTable::decode(std::span<const std::uint8_t> bytes) {
    using core::ErrorCode;
    if (bytes.size() > kMaximumBytes)
        return core::fail(ErrorCode::badInput,
                          place(kMaximumBytes) + "found " + std::to_string(bytes.size()) +
                              " bytes, expected at most " + std::to_string(kMaximumBytes));
    ByteCursor in(bytes);
    if (in.word<std::uint32_t>() != kTableMagic)
        return core::fail(ErrorCode::badInput, place(0) + "expected the mark \"CHCT\"");
    const auto version = in.word<std::uint16_t>();
    if (version != kTableVersion)
        return core::fail(ErrorCode::badInput, place(4) + "found version " +
                                                   (version ? std::to_string(*version) : "none") +
                                                   ", expected " + std::to_string(kTableVersion));
    const auto count = in.word<std::uint16_t>();
    if (!count || *count == 0 || *count > kMaximumChannels)
        return core::fail(ErrorCode::badInput, place(6) + "found " + (count ? std::to_string(*count) : "no") +
                                                   " channels, expected 1.." +
                                                   std::to_string(kMaximumChannels));
    std::vector<Channel> channels;
    for (std::size_t i = 0; i < *count; ++i) {
        const std::size_t start = in.position();
        auto channel = readChannel(in);
        if (!channel)
            return core::fail(ErrorCode::badInput, place(start) + "expected channel " + std::to_string(i) +
                                                       " of " + std::to_string(*count) +
                                                       ", whole and with texts of at most " +
                                                       std::to_string(kMaximumText) + " bytes");
        if (const auto flaw = flawOf(*channel, i, channels))
            return core::fail(ErrorCode::badInput, place(start) + "found " + *flaw);
        channels.push_back(std::move(*channel));
    }
    if (in.remaining() != 0)
        return core::fail(ErrorCode::badInput, place(in.position()) + "found " +
                                                   std::to_string(in.remaining()) +
                                                   " bytes more, expected the end");
    return fromChannels(std::move(channels));
}

std::optional<std::size_t> ChannelTable::find(std::uint8_t tool, std::string_view id) const noexcept {
    for (std::size_t i = 0; i < m_channels.size(); ++i)
        if (m_channels[i].tool == tool && m_channels[i].id == id)
            return i;
    return std::nullopt;
}

} // namespace chiron::recording
