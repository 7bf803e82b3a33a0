// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "recording/channel_table.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace chiron::recording {

/// Location of a channel in a HapticFrame; `unknown` for channels of another version, which readers skip.
struct FrameField {
    enum class Type : std::uint8_t { unknown, u8, u16, u32, i32, u64, i64, real };
    Type type = Type::unknown;
    std::size_t offset = 0;    ///< bytes from the start of the frame
    double stepsPerUnit = 1.0; ///< for real
};

/// Returns the field of a channel, from its tool and id (and slot, for an axis or a quantity).
FrameField fieldOf(const Channel& channel) noexcept;

/// Fills a column with the counts of one field over frames. values.size() == frames.size().
void gather(const FrameField& field, std::span<const core::HapticFrame> frames,
            std::span<std::int64_t> values) noexcept;
/// The same if the field has the value of `frame` in all of the frames.
void gatherConstant(const FrameField& field, const core::HapticFrame& frame,
                    std::span<std::int64_t> values) noexcept;
/// ORs into changes[w] the bits in which the w-th 8-byte word of any frame differs from that of the first.
void findChanges(std::span<const core::HapticFrame> frames, std::span<std::uint64_t> changes) noexcept;

/// Writes a column into frames whose field is zero. Returns the first row whose count does not fit the field
/// (the recording is damaged), or values.size().
std::size_t scatter(const FrameField& field, std::span<const std::int64_t> values,
                    std::span<core::HapticFrame> frames) noexcept;
/// Writes one count into a frame. Returns false if it does not fit the field (the recording is damaged).
bool put(const FrameField& field, std::int64_t count, core::HapticFrame& frame) noexcept;

} // namespace chiron::recording
