// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::recording {

static_assert(std::endian::native == std::endian::little,
              "the recording's formats are written as little-endian words");

/// Zig-zag coding: small magnitudes of either sign become small unsigned numbers. Arithmetic is modulo 2^64,
/// so it is defined for every value.
constexpr std::uint64_t zigZag(std::uint64_t v) noexcept {
    return (v << 1) ^ (0 - (v >> 63));
}
constexpr std::uint64_t unZigZag(std::uint64_t z) noexcept {
    return (z >> 1) ^ (0 - (z & 1));
}

template <std::unsigned_integral T> void appendWord(std::vector<std::uint8_t>& out, T value) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(&value);
    out.insert(out.end(), bytes, bytes + sizeof(T));
}

/// LEB128: seven bits per byte, low first; at most ten bytes.
inline void appendVarint(std::vector<std::uint8_t>& out, std::uint64_t value) {
    for (; value >= 0x80; value >>= 7)
        out.push_back(static_cast<std::uint8_t>(value | 0x80));
    out.push_back(static_cast<std::uint8_t>(value));
}

/// Appends a short string with a length byte; the caller keeps it below 256 bytes.
inline void appendText(std::vector<std::uint8_t>& out, std::string_view text) {
    out.push_back(static_cast<std::uint8_t>(text.size()));
    out.insert(out.end(), text.begin(), text.end());
}

/// Reads forward through untrusted bytes: every read is checked, and nothing past the end is returned.
class ByteCursor {
public:
    explicit ByteCursor(std::span<const std::uint8_t> bytes) noexcept : m_bytes(bytes) {}

    std::size_t position() const noexcept { return m_position; }
    std::size_t remaining() const noexcept { return m_bytes.size() - m_position; }

    template <std::unsigned_integral T> std::optional<T> word() noexcept {
        if (remaining() < sizeof(T))
            return std::nullopt;
        T value;
        std::memcpy(&value, m_bytes.data() + m_position, sizeof(T));
        m_position += sizeof(T);
        return value;
    }

    std::optional<std::uint64_t> varint() noexcept {
        std::uint64_t value = 0;
        for (unsigned shift = 0; shift < 64; shift += 7) {
            if (remaining() == 0)
                return std::nullopt;
            const std::uint8_t byte = m_bytes[m_position++];
            if (shift == 63 && byte > 1)
                return std::nullopt; // more than 64 bits
            value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
            if (byte < 0x80)
                return value;
        }
        return std::nullopt;
    }

    std::optional<std::span<const std::uint8_t>> bytes(std::size_t count) noexcept {
        if (remaining() < count)
            return std::nullopt;
        const auto taken = m_bytes.subspan(m_position, count);
        m_position += count;
        return taken;
    }

    std::optional<std::string> text(std::size_t maximum) {
        const auto length = word<std::uint8_t>();
        if (!length || *length > maximum)
            return std::nullopt;
        const auto body = bytes(*length);
        if (!body)
            return std::nullopt;
        return std::string(reinterpret_cast<const char*>(body->data()), body->size());
    }

private:
    std::span<const std::uint8_t> m_bytes;
    std::size_t m_position = 0;
};

} // namespace chiron::recording
