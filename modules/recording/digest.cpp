// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording/digest.h"

#include "recording/byte_cursor.h"

#include <algorithm>
#include <sodium.h>

namespace chiron::recording {

namespace {
class Blake2b {
public:
    Blake2b() noexcept { crypto_generichash_init(&m_state, nullptr, 0, sizeof(Digest)); }
    void add(const void* data, std::size_t bytes) noexcept {
        crypto_generichash_update(&m_state, static_cast<const unsigned char*>(data), bytes);
    }
    Digest finish() noexcept {
        Digest digest;
        crypto_generichash_final(&m_state, digest.data(), digest.size());
        return digest;
    }

private:
    crypto_generichash_state m_state;
};

/// Lets libsodium choose its vector variants; without this the portable code runs. Idempotent and
/// thread-safe.
void chooseVariant() {
    static const int once = sodium_init();
    static_cast<void>(once);
}
} // namespace

Digest payloadDigestOf(const Chunk& chunk) {
    chooseVariant();
    std::vector<std::uint8_t> head;
    head.reserve(16);
    appendWord(head, chunk.sequence);
    appendWord(head, chunk.firstTick);
    appendWord(head, chunk.frames);
    Blake2b hash;
    hash.add(head.data(), head.size());
    hash.add(chunk.forceHash.data(), chunk.forceHash.size());
    hash.add(chunk.payload.data(), chunk.payload.size());
    return hash.finish();
}

namespace {
constexpr std::size_t kWrenchParts = 6;
constexpr std::size_t kMostBytes = sizeof(std::uint16_t) + 2 * kWrenchParts * sizeof(double);

/// Writes one tool's two wrenches in the form that is hashed; returns the bytes written, at most kMostBytes.
std::size_t writeWrenches(const core::ToolFrame& tool, std::uint8_t* out) noexcept {
    std::uint16_t mask = 0;
    std::size_t at = sizeof(mask);
    const auto put = [&](std::uint64_t value, bool listed,
                         std::size_t bit) { // no branch, since contact is hard to predict
        std::memcpy(out + at, &value, sizeof(value));
        at += listed ? sizeof(value) : 0;
        mask = static_cast<std::uint16_t>(mask | (listed ? 1u << bit : 0u));
    };
    for (std::size_t i = 0; i < kWrenchParts; ++i) {
        const auto bits = std::bit_cast<std::uint64_t>(tool.tissue[i]);
        put(bits, bits != 0, i);
    }
    for (std::size_t i = 0; i < kWrenchParts; ++i) {
        const auto bits = std::bit_cast<std::uint64_t>(tool.commanded[i]);
        put(bits, bits != std::bit_cast<std::uint64_t>(tool.tissue[i]), kWrenchParts + i);
    }
    std::memcpy(out, &mask, sizeof(mask));
    return at;
}

constexpr std::uint16_t kQuantitiesFollow = 1u << 15; ///< no mask of wrenches sets this bit
constexpr std::size_t kMostQuantityBytes =
    sizeof(kQuantitiesFollow) + sizeof(std::uint32_t) + core::kMaxQuantities * sizeof(double);
static_assert(core::kMaxQuantities <= 32);

/// Writes the scene's recorded quantities in the form that is hashed; nothing if all are +0.0, as in scenes
/// that record none. Returns the bytes written, at most kMostQuantityBytes.
std::size_t writeQuantities(const core::TickHeader& header, std::uint8_t* out) noexcept {
    std::uint32_t mask = 0;
    std::size_t at = sizeof(kQuantitiesFollow) + sizeof(mask);
    for (std::size_t i = 0; i < core::kMaxQuantities; ++i) {
        const auto bits = std::bit_cast<std::uint64_t>(header.quantities[i]);
        if (bits == 0)
            continue;
        mask |= 1u << i;
        std::memcpy(out + at, &bits, sizeof(bits));
        at += sizeof(bits);
    }
    if (mask == 0)
        return 0;
    std::memcpy(out, &kQuantitiesFollow, sizeof(kQuantitiesFollow));
    std::memcpy(out + sizeof(kQuantitiesFollow), &mask, sizeof(mask));
    return at;
}
} // namespace

Digest forceHashOf(std::span<const core::HapticFrame> frames) {
    chooseVariant();
    Blake2b hash;
    std::array<std::uint8_t, 4096> buffer;
    std::size_t filled = 0;
    for (const core::HapticFrame& frame : frames) {
        for (std::size_t t = 0; t < std::min<std::size_t>(frame.tools, core::kMaxTools); ++t) {
            if (filled + kMostBytes + sizeof(double) > buffer.size()) {
                hash.add(buffer.data(), filled);
                filled = 0;
            }
            filled += writeWrenches(frame.tool[t], buffer.data() + filled);
        }
        if (filled + kMostQuantityBytes > buffer.size()) {
            hash.add(buffer.data(), filled);
            filled = 0;
        }
        filled += writeQuantities(frame.header, buffer.data() + filled);
    }
    hash.add(buffer.data(), filled);
    return hash.finish();
}

std::string toHex(const Digest& digest) {
    std::string text(digest.size() * 2 + 1, '\0');
    sodium_bin2hex(text.data(), text.size(), digest.data(), digest.size());
    text.pop_back();
    return text;
}

} // namespace chiron::recording
