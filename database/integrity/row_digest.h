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
/// covers, in the encoding's order. Payloads and free texts are covered through the column with their hash.
struct DigestedTable {
    std::string_view name;
    std::vector<std::string_view> key;
    std::vector<std::string_view> columns;
    std::string_view hashedColumn{}; ///< a payload or text that hashColumn covers; empty: none
    std::string_view hashColumn{};
    std::string_view erasedSql{}; ///< expression that is 1 where an erasure has emptied hashedColumn
    /// How many columns at the end came with a later version of the schema. They are nullable; where the last
    /// ones are NULL the digest leaves them out, so that a row which has none keeps the digest it was born
    /// with.
    std::size_t laterColumns = 0;
    int since = 1; ///< version of the schema that brought the table
    std::string_view erasedWithStudiesSql{}; ///< or where this is 1, which asks tables of kStudyVersion
    std::string_view erasedWithSittingsSql{}; ///< or this, of kSittingsVersion
};

inline constexpr int kStudyVersion = 3; ///< the schema that brought studies
inline constexpr int kNamesVersion = 4; ///< and the one that brought earlier names of people
inline constexpr int kSittingsVersion = 5; ///< and the one that says what run a session was recorded for
inline constexpr int kDecisionsVersion = 7; ///< and the one in which a voided session may be counted again
/// The schema of a file that is verified; an older one lacks later tables.
int schemaVersionOf(Connection& connection);

/// All of them, parents first.
const std::vector<DigestedTable>& digestedTables();
/// The tables of studies (version 3), a part of them.
std::vector<DigestedTable> studyTables();
/// The one of this name; must exist.
const DigestedTable& digestedTable(std::string_view name);

/// BLAKE2b-256 over "chiron-row-1", the table's name, the number of values and each value (but later columns
/// that are NULL at the end): a tag (0 NULL, 1 INTEGER, 2 REAL, 3
/// TEXT, 4 BLOB), then 8 bytes little-endian (two's complement; the double's bits), or an 8-byte length and
/// the bytes.
RowDigest rowDigest(std::string_view table, std::span<const Value> values);

/// BLAKE2b-256 of bytes.
RowDigest bytesDigest(std::span<const std::uint8_t> bytes);
RowDigest textDigest(std::string_view text);
inline Blob toBlob(const RowDigest& digest) {
    return Blob(digest.begin(), digest.end());
}

/// Comma-separated select list that yields, for each covered column, its raw value: text as the stored bytes,
/// each preceded by its type, so that a damaged encoding cannot pass as the same text.
std::string rawSelectList(const DigestedTable& table);

} // namespace chiron::database
