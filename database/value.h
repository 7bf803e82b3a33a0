// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace chiron::database {

using Blob = std::vector<std::uint8_t>;

/// The value of a column: NULL, INTEGER, REAL, TEXT (UTF-8) or BLOB. A value type.
class Value {
public:
    enum class Type : std::uint8_t {
        null = 0,
        integer = 1,
        real = 2,
        text = 3,
        blob = 4
    }; ///< tags of row_digest.h

    Value() = default;
    Value(std::int64_t integer) : m_type(Type::integer), m_integer(integer) {}
    Value(double real) : m_type(Type::real), m_real(real) {}
    Value(std::string text) : m_type(Type::text), m_bytes(std::move(text)) {}
    Value(const Blob& blob) : m_type(Type::blob), m_bytes(blob.begin(), blob.end()) {}

    Type type() const noexcept { return m_type; }
    std::int64_t integer() const noexcept { return m_integer; }
    double real() const noexcept { return m_real; }
    const std::string& bytes() const noexcept { return m_bytes; } ///< bytes of a text or a blob

private:
    Type m_type = Type::null;
    std::int64_t m_integer = 0;
    double m_real = 0.0;
    std::string m_bytes;
};

/// A named column value.
struct Column {
    std::string_view name;
    Value value;
};

/// Returns the lower-case hexadecimal form of bytes.
std::string hex(const std::uint8_t* bytes, std::size_t count);
inline std::string hex(const Blob& bytes) {
    return hex(bytes.data(), bytes.size());
}

/// Convert a 64-bit seed or counter to the form that SQLite stores (same bits, signed), and back.
inline std::int64_t storedFromUnsigned(std::uint64_t value) {
    return static_cast<std::int64_t>(value);
}
inline std::uint64_t unsignedFromStored(std::int64_t value) {
    return static_cast<std::uint64_t>(value);
}

} // namespace chiron::database
