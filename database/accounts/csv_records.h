// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace chiron::database {

/// One line of a table; a quoted field may go over several lines of the file.
struct CsvRecord {
    int line = 1; ///< of the file, where it begins
    std::vector<std::string> fields;
};

struct CsvRecords {
    std::vector<CsvRecord> records; ///< those that are not empty
    bool tooMany = false;           ///< and reading stopped there
    std::optional<int> notClosed;   ///< line of a quotation mark that is never closed
};

/// Fields between delimiters as RFC 4180 has them, quotes doubled inside quotes; lines end with LF, CRLF or CR, also mixed.
/// `firstLine` is the number of the text's first line.
CsvRecords readCsvRecords(const std::string& text, char delimiter, std::size_t most, int firstLine = 1);

/// Excel's own first line "sep=;": the delimiter that it names. Cuts the line off the text.
std::optional<char> takeSeparatorLine(std::string& text);

} // namespace chiron::database
