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

/// Lets libsodium choose its vector variants; idempotent and thread-safe. Without it the portable code runs.
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

Digest forceHashOf(std::span<const core::HapticFrame> frames) {
    chooseVariant();
    Blake2b hash;
    std::array<core::Array6, 64> buffer; // a few blocks at once: the state is entered less often
    std::size_t filled = 0;
    const auto flush = [&] {
        hash.add(buffer.data(), filled * sizeof(core::Array6));
        filled = 0;
    };
    for (const core::HapticFrame& frame : frames) {
        const auto tools = std::min<std::size_t>(frame.tools, core::kMaxTools);
        if (filled + 2 * tools > buffer.size())
            flush();
        for (std::size_t t = 0; t < tools; ++t) {
            buffer[filled++] = frame.tool[t].tissue;
            buffer[filled++] = frame.tool[t].commanded;
        }
    }
    flush();
    return hash.finish();
}

std::string toHex(const Digest& digest) {
    std::string text(digest.size() * 2 + 1, '\0');
    sodium_bin2hex(text.data(), text.size(), digest.data(), digest.size());
    text.pop_back();
    return text;
}

} // namespace chiron::recording
