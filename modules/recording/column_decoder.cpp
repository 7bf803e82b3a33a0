// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/column_decoder.h"

#include "recording/bit_packing.h"
#include "recording/byte_cursor.h"

#include <algorithm>
#include <zstd.h>

namespace chiron::recording {

namespace {
tl::unexpected<core::Error> flaw(std::size_t offset, const std::string& expected) {
    return core::fail(core::ErrorCode::badInput, "byte " + std::to_string(offset) + ": expected " + expected);
}

/// Undoes the packed modes: `words` are the packed numbers, `head` and `step` the one or two leading numbers.
void rebuild(ColumnMode mode, std::uint64_t head, std::uint64_t step, std::span<const std::uint64_t> words,
             std::span<std::int64_t> values) noexcept {
    if (mode == ColumnMode::offset) {
        for (std::size_t i = 0; i < words.size(); ++i)
            values[i] = static_cast<std::int64_t>(head + unZigZag(words[i]));
        return;
    }
    std::uint64_t value = head;
    std::size_t at = 0;
    values[at++] = static_cast<std::int64_t>(value);
    if (mode == ColumnMode::difference) {
        for (const std::uint64_t w : words) {
            value += unZigZag(w);
            values[at++] = static_cast<std::int64_t>(value);
        }
        return;
    }
    value += step;
    values[at++] = static_cast<std::int64_t>(value);
    for (const std::uint64_t w : words) {
        step += unZigZag(w);
        value += step;
        values[at++] = static_cast<std::int64_t>(value);
    }
}

void drawLine(std::uint64_t value, std::uint64_t step, std::span<std::int64_t> values) noexcept {
    for (std::int64_t& v : values) {
        v = static_cast<std::int64_t>(value);
        value += step;
    }
}
} // namespace

struct ColumnDecoder::Context {
    std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> zstd{ZSTD_createDCtx(), &ZSTD_freeDCtx};
};

ColumnDecoder::ColumnDecoder() : m_context(std::make_unique<Context>()) {}
ColumnDecoder::~ColumnDecoder() = default;

core::Result<void> ColumnDecoder::decode(std::span<const std::uint8_t> bytes, std::size_t offset,
                                         std::span<std::int64_t> values) {
    if (bytes.empty())
        return flaw(offset, "a column");
    const auto mode = static_cast<std::uint8_t>(bytes[0] & ~kReferred);
    if (mode != static_cast<std::uint8_t>(ColumnMode::zstd))
        return decodePlain(mode, bytes, offset, values);
    CHIRON_TRY(inflate(bytes, offset, values.size()));
    return decodePlain(m_plain[0], m_plain, offset, values);
}

core::Result<void> ColumnDecoder::inflate(std::span<const std::uint8_t> bytes, std::size_t offset,
                                          std::size_t values) {
    ByteCursor in(bytes.subspan(1));
    const auto length = in.varint();
    const std::size_t limit = maximumPlainBytes(values);
    if (!length || *length == 0 || *length > limit)
        return flaw(offset + 1, "the length of a compressed column, 1.." + std::to_string(limit));
    const auto frame = *in.bytes(in.remaining());
    const std::size_t at = offset + bytes.size() - frame.size();
    if (ZSTD_getFrameContentSize(frame.data(), frame.size()) != *length)
        return flaw(at, "a zstd frame of " + std::to_string(*length) + " bytes");
    m_plain.resize(static_cast<std::size_t>(*length));
    if (!m_context->zstd)
        return core::fail(core::ErrorCode::storage, "no memory for decompression");
    const std::size_t got = ZSTD_decompressDCtx(m_context->zstd.get(), m_plain.data(), m_plain.size(),
                                                frame.data(), frame.size());
    if (ZSTD_isError(got) || got != m_plain.size())
        return flaw(at, "a whole zstd frame");
    return {};
}

core::Result<void> ColumnDecoder::decodePlain(std::uint8_t modeByte, std::span<const std::uint8_t> bytes,
                                              std::size_t offset, std::span<std::int64_t> values) {
    if (modeByte > static_cast<std::uint8_t>(ColumnMode::secondDifference))
        return flaw(offset, "a column mode 0..5");
    ByteCursor in(bytes);
    in.bytes(1);
    const auto mode = static_cast<ColumnMode>(modeByte);
    const bool hasHead = mode != ColumnMode::zero;
    const bool hasStep = mode == ColumnMode::line || mode == ColumnMode::secondDifference;
    const auto head = hasHead ? in.varint() : std::optional<std::uint64_t>(0);
    const auto step = hasStep ? in.varint() : std::optional<std::uint64_t>(0);
    if (!head || !step)
        return flaw(offset + in.position(), "a varint of at most 64 bits");
    const std::size_t leading = mode == ColumnMode::offset ? 0 : mode == ColumnMode::difference ? 1 : 2;
    if (mode == ColumnMode::zero || mode == ColumnMode::constant || mode == ColumnMode::line) {
        drawLine(unZigZag(*head), unZigZag(*step), values);
    } else {
        if (values.size() < leading)
            return flaw(offset, "a mode for a column of " + std::to_string(values.size()) + " value");
        m_words.resize(values.size() - leading);
        const auto packed = bytes.subspan(in.position());
        const Unpacked result = unpackBlocks(packed, m_words);
        if (result.flawAt != Unpacked::npos)
            return flaw(offset + in.position() + result.flawAt,
                        "a block: its width 0..64 and all of its values");
        in.bytes(result.used);
        rebuild(mode, unZigZag(*head), unZigZag(*step), m_words, values);
    }
    if (in.remaining() != 0)
        return flaw(offset + in.position(),
                    "the end of the column, found " + std::to_string(in.remaining()) + " bytes");
    return {};
}

} // namespace chiron::recording
