// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/bit_packing.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace chiron::recording {

namespace {
constexpr unsigned kMaximumWidth = 64;
constexpr std::size_t kLoadMargin = 9; // a value of up to 64 bits that starts inside a byte touches nine

unsigned widthOf(std::span<const std::uint64_t> block) noexcept {
    std::uint64_t all = 0;
    for (const std::uint64_t v : block)
        all |= v;
    return static_cast<unsigned>(std::bit_width(all));
}

constexpr std::size_t blockBytes(std::size_t count, unsigned width) noexcept { return (count * width + 7) / 8; }

void packBlock(std::span<const std::uint64_t> block, unsigned width, std::uint8_t* out) noexcept {
    std::uint64_t pending = 0;
    unsigned filled = 0;
    for (const std::uint64_t v : block) {
        pending |= v << filled;
        filled += width;
        if (filled < 64)
            continue;
        std::memcpy(out, &pending, sizeof(pending));
        out += sizeof(pending);
        filled -= 64;
        pending = filled == 0 ? 0 : v >> (width - filled);
    }
    std::memcpy(out, &pending, (filled + 7) / 8);
}

void unpackBlock(const std::uint8_t* in, unsigned width, std::span<std::uint64_t> block) noexcept {
    const std::uint64_t mask = width == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << width) - 1;
    std::size_t bit = 0;
    for (std::uint64_t& v : block) {
        const std::uint8_t* at = in + bit / 8;
        const unsigned shift = bit % 8;
        std::uint64_t low;
        std::memcpy(&low, at, sizeof(low));
        low >>= shift;
        if (width + shift > 64)
            low |= static_cast<std::uint64_t>(at[8]) << (64 - shift);
        v = low & mask;
        bit += width;
    }
}
} // namespace

std::size_t packedSize(std::span<const std::uint64_t> values) noexcept {
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < values.size(); i += kBlockValues) {
        const auto block = values.subspan(i, std::min(kBlockValues, values.size() - i));
        bytes += 1 + blockBytes(block.size(), widthOf(block));
    }
    return bytes;
}

void packBlocks(std::span<const std::uint64_t> values, std::vector<std::uint8_t>& out) {
    for (std::size_t i = 0; i < values.size(); i += kBlockValues) {
        const auto block = values.subspan(i, std::min(kBlockValues, values.size() - i));
        const unsigned width = widthOf(block);
        out.push_back(static_cast<std::uint8_t>(width));
        const std::size_t start = out.size();
        out.resize(start + blockBytes(block.size(), width));
        if (width > 0)
            packBlock(block, width, out.data() + start);
    }
}

Unpacked unpackBlocks(std::span<const std::uint8_t> bytes, std::span<std::uint64_t> values) noexcept {
    std::size_t at = 0;
    for (std::size_t i = 0; i < values.size(); i += kBlockValues) {
        const auto block = values.subspan(i, std::min(kBlockValues, values.size() - i));
        if (at >= bytes.size() || bytes[at] > kMaximumWidth)
            return {at, at};
        const unsigned width = bytes[at];
        const std::size_t length = blockBytes(block.size(), width);
        if (bytes.size() - at - 1 < length)
            return {at, at};
        const std::uint8_t* packed = bytes.data() + at + 1;
        if (width == 0) {
            std::fill(block.begin(), block.end(), 0);
        } else if (bytes.size() - at - 1 >= length + kLoadMargin) {
            unpackBlock(packed, width, block);
        } else { // too near the end to load whole words
            std::array<std::uint8_t, kBlockValues * 8 + kLoadMargin> padded{};
            std::memcpy(padded.data(), packed, length);
            unpackBlock(padded.data(), width, block);
        }
        at += 1 + length;
    }
    return {at, Unpacked::npos};
}

} // namespace chiron::recording
