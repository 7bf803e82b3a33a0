// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/connection.h"
#include "database/value.h"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::database {

using RowDigest = std::array<std::uint8_t, 32>;

/// A table whose rows carry a digest: the columns that identify a row for people, and those that the digest
/// covers, in the order of the encoding. Payloads and free texts are covered through the column that holds
/// their hash.
struct DigestedTable {
    std::string_view name;
    std::vector<std::string_view> key;
    std::vector<std::string_view> columns;
    std::string_view hashedColumn{}; ///< a payload or text that hashColumn covers; empty: none
    std::string_view hashColumn{};
    std::string_view erasedSql{}; ///< expression that is 1 if an erasure has emptied hashedColumn
    /// Number of columns at the end that a later version of the schema added. They are nullable, and the
    /// digest omits those at the end that are NULL, so that a row without them keeps its original digest.
    std::size_t laterColumns = 0;
    int since = 1; ///< version of the schema that added the table
    /// Alternative to erasedSql that reads tables of kStudyVersion.
    std::string_view erasedWithStudiesSql{};
    std::string_view erasedWithSittingsSql{}; ///< alternative to erasedSql for kSittingsVersion
};

inline constexpr int kStudyVersion = 3;    ///< version of the schema that added studies
inline constexpr int kNamesVersion = 4;    ///< version that added earlier names of people
inline constexpr int kSittingsVersion = 5; ///< version that added for which run a session was recorded
/// Version in which a voided session may be reinstated.
inline constexpr int kDecisionsVersion = 7;
/// Returns the schema version of a file that is verified; an older one lacks later tables.
int schemaVersionOf(Connection& connection);

/// Returns all digested tables, parents first.
const std::vector<DigestedTable>& digestedTables();
/// Returns only the tables of studies (version 3).
std::vector<DigestedTable> studyTables();
/// Returns the table of this name, which must exist.
const DigestedTable& digestedTable(std::string_view name);

/// Returns BLAKE2b-256 over "chiron-row-1", the table's name, the number of values and each value (without
/// later columns that are NULL at the end). A value is encoded as a tag (0 NULL, 1 INTEGER, 2 REAL, 3 TEXT, 4
/// BLOB), then 8 bytes little-endian (two's complement, or the bits of the double), or an 8-byte length and
/// the bytes.
RowDigest rowDigest(std::string_view table, std::span<const Value> values);

/// Returns BLAKE2b-256 of bytes.
RowDigest bytesDigest(std::span<const std::uint8_t> bytes);
RowDigest textDigest(std::string_view text);
inline Blob toBlob(const RowDigest& digest) {
    return Blob(digest.begin(), digest.end());
}

/// Returns a comma-separated select list that yields the raw value of each covered column (text as the stored
/// bytes), each preceded by its type, so that a damaged encoding cannot pass as the same text.
std::string rawSelectList(const DigestedTable& table);

} // namespace chiron::database
