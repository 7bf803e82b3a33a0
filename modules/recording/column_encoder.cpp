// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/column_encoder.h"

#include "recording/bit_packing.h"
#include "recording/byte_cursor.h"
#include "recording/vector_variants.h"

#include <algorithm>
#include <zstd.h>

namespace chiron::recording {

namespace {
constexpr int kZstdLevel = 1;                 // higher levels find nothing more in a few hundred bytes
constexpr std::size_t kWorthCompressing = 64; // a zstd frame alone costs about ten bytes

constexpr std::uint64_t bits(std::int64_t v) noexcept {
    return static_cast<std::uint64_t>(v);
}

void appendMode(std::vector<std::uint8_t>& out, ColumnMode mode) {
    out.push_back(static_cast<std::uint8_t>(mode));
}
void appendSigned(std::vector<std::uint8_t>& out, std::uint64_t v) {
    appendVarint(out, zigZag(v));
}

CHIRON_AVX2_TOO bool isConstant(std::span<const std::int64_t> values) noexcept {
    std::int64_t differs = 0;
    for (const std::int64_t v : values)
        differs |= v ^ values[0];
    return differs == 0;
}

/// Computes the three candidates, zig-zag coded: value − base, differences, second differences. n >= 2
/// values; the spans have n, n − 1 and n − 2. Returns the OR of the second differences: 0 for a straight
/// line.
CHIRON_AVX2_TOO std::uint64_t derive(const std::int64_t* values, std::size_t n, std::uint64_t base,
                                     std::uint64_t* offsets, std::uint64_t* first,
                                     std::uint64_t* second) noexcept {
    std::uint64_t bend = 0;
    for (std::size_t i = 0; i < n; ++i)
        offsets[i] = zigZag(bits(values[i]) - base);
    for (std::size_t i = 1; i < n; ++i)
        first[i - 1] = zigZag(bits(values[i]) - bits(values[i - 1]));
    for (std::size_t i = 2; i < n; ++i) {
        second[i - 2] = zigZag(bits(values[i]) - 2 * bits(values[i - 1]) + bits(values[i - 2]));
        bend |= second[i - 2];
    }
    return bend;
}
} // namespace

struct ColumnEncoder::Context {
    std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> zstd{ZSTD_createCCtx(), &ZSTD_freeCCtx};
};

ColumnEncoder::ColumnEncoder() : m_context(std::make_unique<Context>()) {}
ColumnEncoder::~ColumnEncoder() = default;

void ColumnEncoder::encodePlain(std::span<const std::int64_t> values, std::vector<std::uint8_t>& out) {
    if (isConstant(values)) {
        appendMode(out, values[0] == 0 ? ColumnMode::zero : ColumnMode::constant);
        if (values[0] != 0)
            appendSigned(out, bits(values[0]));
        return;
    }
    const std::size_t n = values.size(); // at least 2: a single value is constant
    std::uint64_t sum = 0;
    for (const std::int64_t v : values)
        sum += bits(v);
    // The mean, or any number if the sum overflowed: every base is correct modulo 2^64, and a central one is
    // short.
    const std::uint64_t base = bits(static_cast<std::int64_t>(sum) / static_cast<std::int64_t>(n));
    m_offsets.resize(n);
    m_first.resize(n - 1);
    m_second.resize(n - 2);
    const std::uint64_t step = bits(values[1]) - bits(values[0]);
    const std::uint64_t bend =
        derive(values.data(), n, base, m_offsets.data(), m_first.data(), m_second.data());
    if (bend == 0) {
        appendMode(out, ColumnMode::line);
        appendSigned(out, bits(values[0]));
        appendSigned(out, step);
        return;
    }
    const std::size_t offsetBytes = packedSize(m_offsets);
    const std::size_t firstBytes = packedSize(m_first);
    const std::size_t secondBytes = packedSize(m_second);
    if (offsetBytes <= firstBytes && offsetBytes <= secondBytes) {
        appendMode(out, ColumnMode::offset);
        appendSigned(out, base);
        packBlocks(m_offsets, out);
    } else if (firstBytes <= secondBytes) {
        appendMode(out, ColumnMode::difference);
        appendSigned(out, bits(values[0]));
        packBlocks(m_first, out);
    } else {
        appendMode(out, ColumnMode::secondDifference);
        appendSigned(out, bits(values[0]));
        appendSigned(out, step);
        packBlocks(m_second, out);
    }
}

bool ColumnEncoder::encode(std::span<const std::int64_t> values, bool tryZstd,
                           std::vector<std::uint8_t>& out) {
    const std::size_t start = out.size();
    encodePlain(values, out);
    const std::size_t plain = out.size() - start;
    if (!tryZstd || plain < kWorthCompressing || !m_context->zstd)
        return false;
    m_compressed.resize(ZSTD_compressBound(plain));
    const std::size_t size = ZSTD_compressCCtx(m_context->zstd.get(), m_compressed.data(),
                                               m_compressed.size(), out.data() + start, plain, kZstdLevel);
    if (ZSTD_isError(size) ||
        size + plain / 8 >= plain) // less than an eighth is not worth the time of reading
        return false;
    out.resize(start);
    appendMode(out, ColumnMode::zstd);
    appendVarint(out, plain);
    out.insert(out.end(), m_compressed.begin(), m_compressed.begin() + static_cast<std::ptrdiff_t>(size));
    return true;
}

} // namespace chiron::recording
