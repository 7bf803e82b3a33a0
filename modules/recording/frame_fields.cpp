// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/frame_fields.h"

#include "recording/vector_variants.h"
#include "recording/wrench_rounding.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <string_view>

namespace chiron::recording {

namespace {
using core::Command;
using core::HapticFrame;
using core::TickHeader;
using core::ToolFrame;
using Type = FrameField::Type;

struct Known {
    std::string_view id;
    Type type;
    std::size_t offset;
};

constexpr std::size_t kHeader = offsetof(HapticFrame, header);
constexpr std::size_t kCommands = kHeader + offsetof(TickHeader, commands);

constexpr std::array<Known, 15> kHeaderFields = {{
    {"tick", Type::u64, kHeader + offsetof(TickHeader, index)},
    {"now", Type::i64, kHeader + offsetof(TickHeader, now_ns)},
    {"events", Type::u32, kHeader + offsetof(TickHeader, events)},
    {"guards", Type::u32, kHeader + offsetof(TickHeader, guards)},
    {"trial", Type::u16, kHeader + offsetof(TickHeader, trial)},
    {"heartbeat_age", Type::u16, kHeader + offsetof(TickHeader, heartbeatAge_ms)},
    {"phase", Type::u8, kHeader + offsetof(TickHeader, phase)},
    {"force_state", Type::u8, kHeader + offsetof(TickHeader, force)},
    {"paused", Type::u8, kHeader + offsetof(TickHeader, paused)},
    {"command_0_kind", Type::u16, kCommands + offsetof(Command, kind)},
    {"command_0_argument", Type::u16, kCommands + offsetof(Command, argument)},
    {"command_1_kind", Type::u16, kCommands + sizeof(Command) + offsetof(Command, kind)},
    {"command_1_argument", Type::u16, kCommands + sizeof(Command) + offsetof(Command, argument)},
    {"energy.supplied", Type::real, kHeader + offsetof(TickHeader, energySupplied_J)},
    {"energy.stored", Type::real, kHeader + offsetof(TickHeader, energyStored_J)},
}};

constexpr std::size_t real(std::size_t array, std::size_t i) {
    return array + i * sizeof(double);
}
constexpr std::size_t kTissue = offsetof(ToolFrame, tissue);
constexpr std::size_t kCommanded = offsetof(ToolFrame, commanded);
constexpr std::size_t kMeasured = offsetof(ToolFrame, measured);
constexpr std::size_t kDisplay = offsetof(ToolFrame, display);

constexpr std::array<Known, 27> kToolFields = {{
    {"jaw", Type::i32, offsetof(ToolFrame, jawCounts)},
    {"buttons", Type::u32, offsetof(ToolFrame, buttons)},
    {"packet", Type::u32, offsetof(ToolFrame, packet)},
    {"status", Type::u32, offsetof(ToolFrame, status)},
    {"device_time", Type::u64, offsetof(ToolFrame, deviceTime_us)},
    {"age", Type::u32, offsetof(ToolFrame, age_us)},
    {"tissue.fx", Type::real, real(kTissue, 0)},
    {"tissue.fy", Type::real, real(kTissue, 1)},
    {"tissue.fz", Type::real, real(kTissue, 2)},
    {"tissue.tx", Type::real, real(kTissue, 3)},
    {"tissue.ty", Type::real, real(kTissue, 4)},
    {"tissue.tz", Type::real, real(kTissue, 5)},
    {"commanded.fx", Type::real, real(kCommanded, 0)},
    {"commanded.fy", Type::real, real(kCommanded, 1)},
    {"commanded.fz", Type::real, real(kCommanded, 2)},
    {"commanded.tx", Type::real, real(kCommanded, 3)},
    {"commanded.ty", Type::real, real(kCommanded, 4)},
    {"commanded.tz", Type::real, real(kCommanded, 5)},
    {"measured.fx", Type::real, real(kMeasured, 0)},
    {"measured.fy", Type::real, real(kMeasured, 1)},
    {"measured.fz", Type::real, real(kMeasured, 2)},
    {"measured.tx", Type::real, real(kMeasured, 3)},
    {"measured.ty", Type::real, real(kMeasured, 4)},
    {"measured.tz", Type::real, real(kMeasured, 5)},
    {"display.normal_force", Type::real, real(kDisplay, 0)},
    {"display.pitch", Type::real, real(kDisplay, 1)},
    {"display.roll", Type::real, real(kDisplay, 2)},
}};

template <class T>
void gatherAs(std::size_t offset, std::span<const HapticFrame> frames,
              std::span<std::int64_t> values) noexcept {
    for (std::size_t i = 0; i < frames.size(); ++i) {
        T value;
        std::memcpy(&value, reinterpret_cast<const std::uint8_t*>(&frames[i]) + offset, sizeof(T));
        values[i] = static_cast<std::int64_t>(value);
    }
}

void gatherReal(const FrameField& field, std::span<const HapticFrame> frames,
                std::span<std::int64_t> values) noexcept {
    for (std::size_t i = 0; i < frames.size(); ++i) {
        double value;
        std::memcpy(&value, reinterpret_cast<const std::uint8_t*>(&frames[i]) + field.offset, sizeof(value));
        values[i] = quantise(value, field.stepsPerUnit);
    }
}

template <class T>
std::size_t scatterAs(std::size_t offset, std::span<const std::int64_t> values,
                      std::span<HapticFrame> frames) noexcept {
    std::size_t row = 0;
    for (; row < values.size(); ++row) {
        const T value = static_cast<T>(values[row]);
        std::memcpy(reinterpret_cast<std::uint8_t*>(&frames[row]) + offset, &value, sizeof(T));
        if (static_cast<std::int64_t>(value) != values[row])
            break;
    }
    return row;
}

template <class T> bool putAs(std::size_t offset, std::int64_t count, HapticFrame& frame) noexcept {
    const T value = static_cast<T>(count);
    std::memcpy(reinterpret_cast<std::uint8_t*>(&frame) + offset, &value, sizeof(T));
    return static_cast<std::int64_t>(value) == count;
}
} // namespace

FrameField fieldOf(const Channel& channel) noexcept {
    FrameField field;
    const std::size_t base =
        channel.tool == kNoTool ? 0 : offsetof(HapticFrame, tool) + channel.tool * sizeof(ToolFrame);
    if (channel.tool != kNoTool && channel.id.starts_with("axis.")) {
        if (channel.slot >= core::kMaxCoordinates)
            return field;
        field.type = Type::i32;
        field.offset = base + offsetof(ToolFrame, counts) + channel.slot * sizeof(std::int32_t);
        return field;
    }
    if (channel.tool == kNoTool && channel.id.starts_with("quantity.")) {
        if (channel.slot >= core::kMaxQuantities || channel.kind != ChannelKind::quantised)
            return field;
        return {Type::real, kHeader + offsetof(TickHeader, quantities) + channel.slot * sizeof(double),
                stepsPerUnit(channel.resolution)};
    }
    const auto known =
        channel.tool == kNoTool ? std::span<const Known>(kHeaderFields) : std::span<const Known>(kToolFields);
    for (const Known& k : known)
        if (k.id == channel.id && (k.type == Type::real) == (channel.kind == ChannelKind::quantised))
            field = {k.type, base + k.offset, stepsPerUnit(channel.resolution)};
    return field;
}

void gather(const FrameField& field, std::span<const HapticFrame> frames,
            std::span<std::int64_t> values) noexcept {
    switch (field.type) {
    case Type::u8:
        return gatherAs<std::uint8_t>(field.offset, frames, values);
    case Type::u16:
        return gatherAs<std::uint16_t>(field.offset, frames, values);
    case Type::u32:
        return gatherAs<std::uint32_t>(field.offset, frames, values);
    case Type::i32:
        return gatherAs<std::int32_t>(field.offset, frames, values);
    case Type::u64:
        return gatherAs<std::uint64_t>(field.offset, frames, values);
    case Type::i64:
        return gatherAs<std::int64_t>(field.offset, frames, values);
    case Type::real:
        return gatherReal(field, frames, values);
    case Type::unknown:
        break;
    }
    std::memset(values.data(), 0, values.size_bytes());
}

void gatherConstant(const FrameField& field, const HapticFrame& frame,
                    std::span<std::int64_t> values) noexcept {
    std::int64_t value = 0;
    gather(field, {&frame, 1}, {&value, 1});
    std::fill(values.begin(), values.end(), value);
}

CHIRON_AVX2_TOO void findChanges(std::span<const HapticFrame> frames,
                                 std::span<std::uint64_t> changes) noexcept {
    std::array<std::uint64_t, sizeof(HapticFrame) / sizeof(std::uint64_t)> first;
    std::memcpy(first.data(), &frames.front(), sizeof(first));
    const std::size_t words = std::min(changes.size(), first.size());
    for (const HapticFrame& frame : frames) {
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(&frame);
        for (std::size_t w = 0; w < words; ++w) {
            std::uint64_t word;
            std::memcpy(&word, bytes + w * sizeof(word), sizeof(word));
            changes[w] |= word ^ first[w];
        }
    }
}

std::size_t scatter(const FrameField& field, std::span<const std::int64_t> values,
                    std::span<HapticFrame> frames) noexcept {
    std::int64_t any = 0;
    for (const std::int64_t v : values)
        any |= v;
    if (any == 0)
        return values.size(); // the frames are already zero
    switch (field.type) {
    case Type::u8:
        return scatterAs<std::uint8_t>(field.offset, values, frames);
    case Type::u16:
        return scatterAs<std::uint16_t>(field.offset, values, frames);
    case Type::u32:
        return scatterAs<std::uint32_t>(field.offset, values, frames);
    case Type::i32:
        return scatterAs<std::int32_t>(field.offset, values, frames);
    case Type::u64:
        return scatterAs<std::uint64_t>(field.offset, values, frames);
    case Type::i64:
        return scatterAs<std::int64_t>(field.offset, values, frames);
    case Type::real:
    case Type::unknown:
        break;
    }
    std::size_t row = 0;
    while (row < values.size() && put(field, values[row], frames[row]))
        ++row;
    return row;
}

bool put(const FrameField& field, std::int64_t count, HapticFrame& frame) noexcept {
    switch (field.type) {
    case Type::u8:
        return putAs<std::uint8_t>(field.offset, count, frame);
    case Type::u16:
        return putAs<std::uint16_t>(field.offset, count, frame);
    case Type::u32:
        return putAs<std::uint32_t>(field.offset, count, frame);
    case Type::i32:
        return putAs<std::int32_t>(field.offset, count, frame);
    case Type::u64:
        return putAs<std::uint64_t>(field.offset, count, frame);
    case Type::i64:
        return putAs<std::int64_t>(field.offset, count, frame);
    case Type::real: {
        const double value = dequantise(count, field.stepsPerUnit);
        std::memcpy(reinterpret_cast<std::uint8_t*>(&frame) + field.offset, &value, sizeof(value));
        return count >= -kInfinityQuantum && count <= kNaNQuantum;
    }
    case Type::unknown:
        break;
    }
    return true;
}

} // namespace chiron::recording
