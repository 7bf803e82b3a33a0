// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/crc32c.h"

#include <array>
#include <cstring>
#include <nmmintrin.h>

namespace chiron::recording {

namespace {
constexpr std::uint32_t kReflectedPolynomial = 0x82F63B78;
constexpr std::size_t kLanes = 4;

constexpr std::array<std::uint32_t, 256> makeTable() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < table.size(); ++i) {
        std::uint32_t crc = i;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ ((crc & 1) ? kReflectedPolynomial : 0);
        table[i] = crc;
    }
    return table;
}
constexpr auto kTable = makeTable();

std::uint32_t stepByte(std::uint32_t crc, std::uint8_t byte) noexcept {
    return (crc >> 8) ^ kTable[(crc ^ byte) & 0xff];
}

struct Portable {
    static std::uint32_t step(std::uint32_t crc, std::uint64_t word) noexcept {
        for (int i = 0; i < 8; ++i, word >>= 8)
            crc = stepByte(crc, static_cast<std::uint8_t>(word));
        return crc;
    }
};

std::uint64_t moveWord(std::uint8_t* to, const std::uint8_t* from) noexcept {
    std::uint64_t word;
    std::memcpy(&word, from, sizeof(word));
    std::memcpy(to, &word, sizeof(word));
    return word;
}

__attribute__((target("sse4.2"))) std::uint32_t
copyWithChecksumSse42(std::uint64_t number, void* to, const void* from, std::size_t words) noexcept {
    const auto* in = static_cast<const std::uint8_t*>(from);
    auto* out = static_cast<std::uint8_t*>(to);
    std::uint64_t lane0 = _mm_crc32_u64(0, number);
    std::uint64_t lane1 = 1;
    std::uint64_t lane2 = 2;
    std::uint64_t lane3 = 3;
    for (; words >= kLanes; words -= kLanes, in += 8 * kLanes, out += 8 * kLanes) {
        lane0 = _mm_crc32_u64(lane0, moveWord(out, in));
        lane1 = _mm_crc32_u64(lane1, moveWord(out + 8, in + 8));
        lane2 = _mm_crc32_u64(lane2, moveWord(out + 16, in + 16));
        lane3 = _mm_crc32_u64(lane3, moveWord(out + 24, in + 24));
    }
    if (words > 0)
        lane0 = _mm_crc32_u64(lane0, moveWord(out, in));
    if (words > 1)
        lane1 = _mm_crc32_u64(lane1, moveWord(out + 8, in + 8));
    if (words > 2)
        lane2 = _mm_crc32_u64(lane2, moveWord(out + 16, in + 16));
    return static_cast<std::uint32_t>(
        _mm_crc32_u64(_mm_crc32_u64(_mm_crc32_u64(lane0, lane1), lane2), lane3));
}
} // namespace

std::uint32_t crc32c(std::span<const std::uint8_t> bytes) noexcept {
    std::uint32_t crc = ~std::uint32_t{0};
    for (const std::uint8_t byte : bytes)
        crc = stepByte(crc, byte);
    return ~crc;
}

std::uint32_t copyWithChecksumPortable(std::uint64_t number, void* to, const void* from,
                                       std::size_t words) noexcept {
    const auto* in = static_cast<const std::uint8_t*>(from);
    auto* out = static_cast<std::uint8_t*>(to);
    std::array<std::uint32_t, kLanes> lanes = {Portable::step(0, number), 1, 2, 3};
    for (std::size_t i = 0; i < words; ++i)
        lanes[i % kLanes] = Portable::step(lanes[i % kLanes], moveWord(out + 8 * i, in + 8 * i));
    std::uint32_t folded = lanes[0];
    for (std::size_t k = 1; k < kLanes; ++k)
        folded = Portable::step(folded, lanes[k]);
    return folded;
}

CopyWithChecksum copyWithChecksum() noexcept {
    __builtin_cpu_init();
    return __builtin_cpu_supports("sse4.2") ? &copyWithChecksumSse42 : &copyWithChecksumPortable;
}

} // namespace chiron::recording
