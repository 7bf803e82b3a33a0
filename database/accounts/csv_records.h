// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace chiron::database {

/// One line of a table. A quoted field may span several lines of the file.
struct CsvRecord {
    int line = 1; ///< line of the file where the record begins
    std::vector<std::string> fields;
};

struct CsvRecords {
    std::vector<CsvRecord> records; ///< records that are not empty
    bool tooMany = false;           ///< there were more records, and reading stopped
    std::optional<int> notClosed;   ///< line of a quotation mark that is never closed
};

/// Splits a text into fields between delimiters as in RFC 4180, with quotes doubled inside quotes. Lines end
/// with LF, CRLF or CR, also mixed. `firstLine` is the number of the text's first line.
CsvRecords readCsvRecords(const std::string& text, char delimiter, std::size_t most, int firstLine = 1);

/// Returns the delimiter named by Excel's own first line "sep=;", and removes that line from the text.
std::optional<char> takeSeparatorLine(std::string& text);

} // namespace chiron::database
