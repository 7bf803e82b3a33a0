// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <tl/expected.hpp>

namespace chiron::database {

/// A text file converted to UTF-8, and its original encoding.
struct TableText {
    std::string text;     ///< without a byte order mark
    std::string encoding; ///< "UTF-8", "UTF-16", "Windows-1252", "Windows-1253"
};

/// Why a file is not a text.
struct TextProblem {
    enum class Kind : std::uint8_t {
        excel,        ///< .xlsx
        openDocument, ///< .ods
        oldExcel,     ///< .xls
        pdf,
        archive, ///< another ZIP
        binary,  ///< control characters
        damaged  ///< bytes that are invalid in every encoding
    };
    Kind kind = Kind::damaged;
    int line = 1; ///< line of the first such byte
};

/// Reads a text as spreadsheets save it: UTF-8 or UTF-16 with or without a byte order mark, or the Windows
/// code page of Western Europe or Greece. The encoding is derived from the bytes.
tl::expected<TableText, TextProblem> readTableText(const std::string& bytes);

} // namespace chiron::database
