// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "recording/column_codec.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace chiron::recording {

/// Encodes numbers into the bytes of one column. Not copyable, because it owns a compression context and
/// scratch space.
/// Thread: one at a time.
class ColumnEncoder {
public:
    ColumnEncoder();
    ColumnEncoder(const ColumnEncoder&) = delete;
    ColumnEncoder& operator=(const ColumnEncoder&) = delete;
    ~ColumnEncoder();

    /// Appends the values in the smallest of the plain modes.
    void encodePlain(std::span<const std::int64_t> values, std::vector<std::uint8_t>& out);
    /// Like encodePlain(), but replaces the result by its zstd form if that saves an eighth (tried only if
    /// `tryZstd`). Returns true if it did.
    bool encode(std::span<const std::int64_t> values, bool tryZstd, std::vector<std::uint8_t>& out);

private:
    struct Context;
    std::unique_ptr<Context> m_context;
    std::vector<std::uint64_t> m_offsets, m_first, m_second;
    std::vector<std::uint8_t> m_compressed;
};

} // namespace chiron::recording
