// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/bit_packing.h"

#include "recording/vector_variants.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <utility>

namespace chiron::recording {

namespace {
constexpr unsigned kMaximumWidth = 64;
constexpr unsigned kWordBits = 64;
constexpr std::size_t kWholeBlockBytes = kBlockValues * sizeof(std::uint64_t);

using Block = std::array<std::uint64_t, kBlockValues>;
using PackBlock = void (*)(const std::uint64_t* values, std::uint8_t* out) noexcept;
using UnpackBlock = void (*)(const std::uint8_t* in, std::uint64_t* values) noexcept;

/// Number of 64-bit words of a whole block of that width.
template <unsigned width> constexpr std::size_t kWords = (kBlockValues * width + kWordBits - 1) / kWordBits;

// One unrolled function per width: the compiler knows every shift, which makes packing fast.
template <unsigned width, std::size_t i>
inline void packValue(const std::uint64_t* values, std::uint64_t* words) noexcept {
    constexpr std::size_t kWord = i * width / kWordBits;
    constexpr unsigned kShift = i * width % kWordBits;
    words[kWord] |= values[i] << kShift;
    if constexpr (kShift + width > kWordBits)
        words[kWord + 1] |= values[i] >> (kWordBits - kShift);
}

template <unsigned width, std::size_t i>
inline void unpackValue(const std::uint64_t* words, std::uint64_t* values) noexcept {
    constexpr std::size_t kWord = i * width / kWordBits;
    constexpr unsigned kShift = i * width % kWordBits;
    constexpr std::uint64_t kMask = width == kWordBits ? ~std::uint64_t{0} : (std::uint64_t{1} << width) - 1;
    std::uint64_t value = words[kWord] >> kShift;
    if constexpr (kShift + width > kWordBits)
        value |= words[kWord + 1] << (kWordBits - kShift);
    values[i] = value & kMask;
}

template <unsigned width> void pack(const std::uint64_t* values, std::uint8_t* out) noexcept {
    if constexpr (width > 0) {
        std::array<std::uint64_t, kWords<width>> words{};
        [&]<std::size_t... i>(std::index_sequence<i...>) {
            (packValue<width, i>(values, words.data()), ...);
        }(std::make_index_sequence<kBlockValues>());
        std::memcpy(out, words.data(), kBlockValues * width / 8);
    }
}

template <unsigned width> void unpack(const std::uint8_t* in, std::uint64_t* values) noexcept {
    if constexpr (width == 0) {
        std::fill_n(values, kBlockValues, 0);
    } else {
        std::array<std::uint64_t, kWords<width>> words{};
        std::memcpy(words.data(), in, kBlockValues * width / 8);
        [&]<std::size_t... i>(std::index_sequence<i...>) {
            (unpackValue<width, i>(words.data(), values), ...);
        }(std::make_index_sequence<kBlockValues>());
    }
}

template <unsigned... widths>
constexpr std::array<PackBlock, sizeof...(widths)> packers(std::integer_sequence<unsigned, widths...>) {
    return {&pack<widths>...};
}
template <unsigned... widths>
constexpr std::array<UnpackBlock, sizeof...(widths)> unpackers(std::integer_sequence<unsigned, widths...>) {
    return {&unpack<widths>...};
}
constexpr auto kPackers = packers(std::make_integer_sequence<unsigned, kMaximumWidth + 1>());
constexpr auto kUnpackers = unpackers(std::make_integer_sequence<unsigned, kMaximumWidth + 1>());

inline unsigned widthOf(std::span<const std::uint64_t> block) noexcept {
    std::uint64_t all = 0;
    for (const std::uint64_t v : block)
        all |= v;
    return static_cast<unsigned>(std::bit_width(all));
}

constexpr std::size_t blockBytes(std::size_t count, unsigned width) noexcept {
    return (count * width + 7) / 8;
}
} // namespace

CHIRON_AVX2_TOO std::size_t packedSize(std::span<const std::uint64_t> values) noexcept {
    std::size_t bytes = 0;
    std::size_t i = 0;
    for (; i + kBlockValues <= values.size(); i += kBlockValues)
        bytes += 1 + blockBytes(kBlockValues, widthOf(values.subspan(i).first<kBlockValues>()));
    if (i < values.size())
        bytes += 1 + blockBytes(values.size() - i, widthOf(values.subspan(i)));
    return bytes;
}

void packBlocks(std::span<const std::uint64_t> values, std::vector<std::uint8_t>& out) {
    for (std::size_t i = 0; i < values.size(); i += kBlockValues) {
        const std::size_t count = std::min(kBlockValues, values.size() - i);
        const unsigned width = widthOf(values.subspan(i, count));
        out.push_back(static_cast<std::uint8_t>(width));
        const std::size_t start = out.size();
        if (count == kBlockValues) {
            out.resize(start + blockBytes(count, width));
            kPackers[width](&values[i], out.data() + start);
            continue;
        }
        Block padded{};
        std::copy_n(&values[i], count, padded.begin());
        out.resize(start + blockBytes(kBlockValues, width));
        kPackers[width](padded.data(), out.data() + start);
        out.resize(start + blockBytes(count, width));
    }
}

Unpacked unpackBlocks(std::span<const std::uint8_t> bytes, std::span<std::uint64_t> values) noexcept {
    std::size_t at = 0;
    for (std::size_t i = 0; i < values.size(); i += kBlockValues) {
        const std::size_t count = std::min(kBlockValues, values.size() - i);
        if (at >= bytes.size() || bytes[at] > kMaximumWidth)
            return {at, at};
        const unsigned width = bytes[at];
        const std::size_t length = blockBytes(count, width);
        if (bytes.size() - at - 1 < length)
            return {at, at};
        const std::uint8_t* packed = bytes.data() + at + 1;
        if (count == kBlockValues) {
            kUnpackers[width](packed, &values[i]);
        } else {
            std::array<std::uint8_t, kWholeBlockBytes> padded{};
            Block block;
            std::copy_n(packed, length, padded.begin());
            kUnpackers[width](padded.data(), block.data());
            std::copy_n(block.begin(), count, &values[i]);
        }
        at += 1 + length;
    }
    return {at, Unpacked::npos};
}

} // namespace chiron::recording
