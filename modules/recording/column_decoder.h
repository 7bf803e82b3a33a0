// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "recording/column_codec.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace chiron::recording {

/// Decodes the bytes of one column into numbers. Any bytes give numbers or an Error that states at which byte
/// what was expected. Not copyable.
/// Thread: one at a time.
class ColumnDecoder {
public:
    ColumnDecoder();
    ColumnDecoder(const ColumnDecoder&) = delete;
    ColumnDecoder& operator=(const ColumnDecoder&) = delete;
    ~ColumnDecoder();

    /// Fills `values` (at least one) with the numbers in the column, without adding a reference. The column
    /// must end where `bytes` ends. Offsets in messages count from `offset`.
    core::Result<void> decode(std::span<const std::uint8_t> bytes, std::size_t offset,
                              std::span<std::int64_t> values);

private:
    core::Result<void> decodePlain(std::uint8_t mode, std::span<const std::uint8_t> bytes, std::size_t offset,
                                   std::span<std::int64_t> values);
    core::Result<void> inflate(std::span<const std::uint8_t> bytes, std::size_t offset, std::size_t values);

    struct Context;
    std::unique_ptr<Context> m_context;
    std::vector<std::uint8_t> m_plain;
    std::vector<std::uint64_t> m_words;
};

} // namespace chiron::recording
