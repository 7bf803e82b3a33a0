// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/integrity/row_digest.h"

#include <bit>
#include <sodium.h>

namespace chiron::database {
namespace {

class Hasher {
public:
    Hasher() { crypto_generichash_init(&m_state, nullptr, 0, sizeof(RowDigest)); }
    void bytes(const void* data, std::size_t count) {
        crypto_generichash_update(&m_state, static_cast<const unsigned char*>(data), count);
    }
    void tag(std::uint8_t value) { bytes(&value, 1); }
    void number(std::uint64_t value) {
        std::array<std::uint8_t, 8> little{};
        for (std::size_t i = 0; i < little.size(); ++i) {
            little[i] = static_cast<std::uint8_t>(value >> (8 * i));
        }
        bytes(little.data(), little.size());
    }
    void text(std::string_view text) {
        number(text.size());
        bytes(text.data(), text.size());
    }
    RowDigest result() {
        RowDigest digest{};
        crypto_generichash_final(&m_state, digest.data(), digest.size());
        return digest;
    }

private:
    crypto_generichash_state m_state{};
};

void add(Hasher& hasher, const Value& value) {
    hasher.tag(static_cast<std::uint8_t>(value.type()));
    switch (value.type()) {
    case Value::Type::null:
        return;
    case Value::Type::integer:
        return hasher.number(static_cast<std::uint64_t>(value.integer()));
    case Value::Type::real:
        return hasher.number(std::bit_cast<std::uint64_t>(value.real()));
    case Value::Type::text:
    case Value::Type::blob:
        return hasher.text(value.bytes());
    }
}

} // namespace

RowDigest rowDigest(std::string_view table, std::span<const Value> values) {
    const DigestedTable& spec = digestedTable(table);
    const std::size_t firstVersion = spec.columns.size() - spec.laterColumns;
    while (values.size() > firstVersion && values.back().type() == Value::Type::null) {
        values = values.first(values.size() - 1);
    }
    Hasher hasher;
    hasher.text("chiron-row-1");
    hasher.text(table);
    hasher.number(values.size());
    for (const Value& value : values) {
        add(hasher, value);
    }
    return hasher.result();
}

RowDigest bytesDigest(std::span<const std::uint8_t> bytes) {
    RowDigest digest{};
    crypto_generichash(digest.data(), digest.size(), bytes.data(), bytes.size(), nullptr, 0);
    return digest;
}

RowDigest textDigest(std::string_view text) {
    return bytesDigest({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

std::string rawSelectList(const DigestedTable& table) {
    std::string list;
    for (const std::string_view name : table.columns) {
        const std::string column(name);
        list += (list.empty() ? "" : ", ");
        list += "typeof(" + column + "), CASE typeof(" + column + ") WHEN 'text' THEN CAST(" + column +
                " AS BLOB) ELSE " + column + " END";
    }
    return list;
}

} // namespace chiron::database
