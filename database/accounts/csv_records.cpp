// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/accounts/csv_records.h"

#include <algorithm>

namespace chiron::database {
namespace {

class CsvReader {
public:
    CsvReader(const std::string& text, char delimiter, int firstLine)
        : m_text(text), m_delimiter(delimiter), m_line(firstLine) {
        m_record.line = firstLine;
    }

    CsvRecords read(std::size_t most) {
        for (std::size_t i = 0; i < m_text.size() && m_found.records.size() <= most; ++i) {
            m_quoted ? inside(i) : outside(i);
        }
        m_found.tooMany = m_found.records.size() > most;
        if (m_quoted && !m_found.tooMany) {
            m_found.notClosed = m_quoteLine;
        } else if (!m_found.tooMany) {
            endRecord();
            m_found.tooMany = m_found.records.size() > most;
        }
        return std::move(m_found);
    }

private:
    bool endsLine(std::size_t& i) {
        if (m_text[i] == '\r' && i + 1 < m_text.size() && m_text[i + 1] == '\n') {
            ++i;
        }
        const bool ends = m_text[i] == '\n' || m_text[i] == '\r';
        m_line += ends ? 1 : 0;
        return ends;
    }
    void inside(std::size_t& i) {
        if (m_text[i] != '"') {
            m_field.push_back(endsLine(i) ? '\n' : m_text[i]);
        } else if (i + 1 < m_text.size() && m_text[i + 1] == '"') {
            m_field.push_back(m_text[++i]);
        } else {
            m_quoted = false;
        }
    }
    void outside(std::size_t& i) {
        if (m_text[i] == '"' && m_field.empty()) {
            m_quoted = true;
            m_quoteLine = m_line;
        } else if (m_text[i] == m_delimiter) {
            endField();
        } else if (endsLine(i)) {
            endRecord();
        } else {
            m_field.push_back(m_text[i]);
        }
    }
    void endField() {
        m_record.fields.push_back(std::move(m_field));
        m_field.clear();
    }
    // A spreadsheet writes an empty row as a line that consists only of delimiters.
    void endRecord() {
        endField();
        if (std::any_of(m_record.fields.begin(), m_record.fields.end(), [](const std::string& field) {
                return field.find_first_not_of(" \t\n") != std::string::npos;
            })) {
            m_found.records.push_back(std::move(m_record));
        }
        m_record = CsvRecord{m_line, {}};
    }

    const std::string& m_text;
    const char m_delimiter;
    CsvRecords m_found;
    CsvRecord m_record;
    std::string m_field;
    bool m_quoted = false;
    int m_quoteLine = 1;
    int m_line;
};

} // namespace

CsvRecords readCsvRecords(const std::string& text, char delimiter, std::size_t most, int firstLine) {
    return CsvReader(text, delimiter, firstLine).read(most);
}

std::optional<char> takeSeparatorLine(std::string& text) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    std::string line = text.substr(0, end);
    std::erase(line, '"');
    if (line.size() < 5 || line.size() > 6 ||
        !(line.starts_with("sep=") || line.starts_with("SEP=") || line.starts_with("Sep="))) {
        return std::nullopt;
    }
    const std::size_t next = text.compare(end, 2, "\r\n") == 0 ? end + 2 : std::min(end + 1, text.size());
    text.erase(0, next);
    return line[4];
}

} // namespace chiron::database
