// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/trace_columns.h"
#include "scoring/trace_csv.h"
#include "scoring/trace_grid.h"

#include "core/units.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <system_error>
#include <utility>

namespace chiron::scoring {

namespace {

constexpr std::string_view kHeaderExample = "t_s,x_mm,y_mm,z_mm";

/// Returns the value as a message shows it: at most 40 characters, without control sequences that a terminal
/// would obey.
std::string shown(std::string_view text) {
    constexpr std::size_t kLongest = 40;
    constexpr std::string_view kHex = "0123456789abcdef";
    std::string out = "\"";
    for (const char c : text.substr(0, kLongest)) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x20 && byte < 0x7f)
            out += c;
        else
            out.append("\\x").append(1, kHex[byte >> 4]).append(1, kHex[byte & 15]);
    }
    return out + (text.size() > kLongest ? "...\"" : "\"");
}

constexpr std::size_t kMostNamed = 64; ///< largest number of quantities, and of ground-truth values

/// A column of the file: one of the fixed table, or one that an exercise named.
struct Column {
    const TraceColumn* fixed = nullptr;
    std::vector<double> TraceRow::*list = nullptr;
    std::size_t place = 0; ///< index in the list
};

class Reader {
public:
    Reader(std::string_view text, const std::string& name, std::span<const TraceColumn> known)
        : m_text(text), m_known(known) {
        m_out.source = name;
    }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    core::Result<TraceRows> read() {
        m_lastTime.fill(-std::numeric_limits<double>::infinity());
        if (m_text.starts_with("\xef\xbb\xbf"))
            m_text.remove_prefix(3);
        if (m_text.empty()) {
            m_line = 1;
            return refuse(1, "empty file", "a header line such as " + std::string(kHeaderExample));
        }
        std::string_view line;
        nextLine(line);
        CHIRON_TRY(readHeader(line));
        while (nextLine(line)) {
            const auto row = readRow(line);
            CHIRON_TRY(row);
            if (!*row)
                break;
        }
        if (m_out.rows.empty())
            return refuse(1, "no rows", "at least one row below the header");
        return std::move(m_out);
    }

private:
    tl::unexpected<core::Error> refuse(std::size_t column, const std::string& found,
                                       const std::string& expected) const {
        return core::fail(core::ErrorCode::badInput, m_out.source + ":" + std::to_string(m_line) + ":" +
                                                         std::to_string(column) + ": " + found +
                                                         ": expected " + expected);
    }

    bool nextLine(std::string_view& line) {
        if (m_text.empty())
            return false;
        const std::size_t end = m_text.find('\n');
        line = m_text.substr(0, end);
        m_text.remove_prefix(end == std::string_view::npos ? m_text.size() : end + 1);
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        ++m_line;
        return true;
    }

    core::Result<void> readHeader(std::string_view line) {
        std::vector<bool> seen(m_known.size(), false);
        for (std::size_t start = 0, number = 1; start <= line.size(); ++number) {
            const std::size_t end = std::min(line.find(',', start), line.size());
            const std::string_view name = line.substr(start, end - start);
            start = end + 1;
            const auto column = std::find_if(m_known.begin(), m_known.end(),
                                             [&](const TraceColumn& one) { return one.name == name; });
            if (column != m_known.end()) {
                const auto place = static_cast<std::size_t>(column - m_known.begin());
                if (seen[place])
                    return refuse(number, shown(name), "each column once");
                seen[place] = true;
                m_columns.push_back({&m_known[place], nullptr, 0});
            } else {
                CHIRON_TRY(addNamed(name, number));
            }
        }
        return checkGroups(seen);
    }

    /// Adds a column that an exercise named.
    core::Result<void> addNamed(std::string_view name, std::size_t number) {
        const std::string_view quantity = namedColumnId(name, kQuantityPrefix);
        const std::string_view truth = namedColumnId(name, kTruthPrefix);
        if (quantity.empty() && truth.empty())
            return refuse(number, shown(name), "a column name: " + allNames());
        auto& ids = truth.empty() ? m_out.columns.quantities : m_out.columns.truth;
        const std::string_view id = truth.empty() ? quantity : truth;
        if (std::find(ids.begin(), ids.end(), id) != ids.end())
            return refuse(number, shown(name), "each column once");
        if (ids.size() >= kMostNamed)
            return refuse(number, shown(name), "at most " + std::to_string(kMostNamed) + " of its kind");
        m_columns.push_back({nullptr, truth.empty() ? &TraceRow::quantities : &TraceRow::truth, ids.size()});
        ids.emplace_back(id);
        return {};
    }

    core::Result<void> checkGroups(const std::vector<bool>& seen) {
        TraceColumns& present = m_out.columns;
        for (std::size_t i = 0; i < m_known.size(); ++i) {
            const TraceColumn& column = m_known[i];
            if (seen[i] && column.owner != nullptr) {
                if (present.own != nullptr && present.own != column.owner)
                    return refuse(1, std::string(column.name),
                                  "only columns of one exercise: the file already has those of " +
                                      std::string(present.own->of));
                present.own = column.owner;
            } else if (seen[i] && column.group != nullptr) {
                present.*column.group = true;
            }
        }
        for (std::size_t i = 0; i < m_known.size(); ++i)
            if (const TraceColumn& column = m_known[i]; !seen[i] && column.presentIn(present))
                return refuse(1, "no column \"" + std::string(column.name) + "\"",
                              column.group == nullptr && column.owner == nullptr
                                  ? "t_s,x_mm,y_mm,z_mm at least"
                                  : "all columns of its group or none of them");
        if (present.own == nullptr || present.own->required == nullptr || present.*present.own->required)
            return {};
        for (const TraceColumn& column : m_known)
            if (column.group == present.own->required)
                return refuse(1, "no column \"" + std::string(column.name) + "\"",
                              "it beside those of " + std::string(present.own->of));
        return {};
    }

    std::string allNames() const {
        std::string names;
        for (const TraceColumn& column : m_known)
            names.append(names.empty() ? "" : ",").append(column.name);
        for (const std::string_view prefix : {kQuantityPrefix, kTruthPrefix})
            names.append(",").append(prefix).append("<id>");
        return names;
    }

    /// Reads a row. Returns false at the empty lines that may end a file.
    core::Result<bool> readRow(std::string_view line) {
        if (line.empty()) {
            if (m_text.find_first_not_of("\r\n") != std::string_view::npos)
                return refuse(1, "empty line", "a row (empty lines only at the end)");
            return false;
        }
        TraceRow row;
        row.quantities.resize(m_out.columns.quantities.size());
        row.truth.resize(m_out.columns.truth.size());
        if (m_out.columns.own != nullptr)
            row.own.resize(m_out.columns.own->columns.size());
        std::size_t start = 0;
        for (std::size_t i = 0; i < m_columns.size(); ++i) {
            if (start > line.size())
                return refuse(i + 1, "row of " + std::to_string(i) + " values", columnCount());
            const std::size_t end = std::min(line.find(',', start), line.size());
            CHIRON_TRY(setValue(row, m_columns[i], line.substr(start, end - start), i + 1));
            start = end + 1;
        }
        if (start <= line.size())
            return refuse(m_columns.size() + 1, "row with more values: " + shown(line.substr(start)),
                          columnCount());
        return accept(row);
    }

    std::string columnCount() const { return std::to_string(m_columns.size()) + " values as in the header"; }

    core::Result<void> setValue(TraceRow& row, const Column& column, std::string_view text,
                                std::size_t number) const {
        if (column.fixed != nullptr) {
            const auto value = readValue(*column.fixed, text, number);
            CHIRON_TRY(value);
            column.fixed->setIn(row, *value);
            return {};
        }
        double value = std::numeric_limits<double>::quiet_NaN(); // an empty field means that there is no
                                                                 // value
        if (!text.empty()) {
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
            if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
                return refuse(number, shown(text), "a finite number, or nothing");
        }
        (row.*column.list)[column.place] = value;
        return {};
    }

    core::Result<double> readValue(const TraceColumn& column, std::string_view text,
                                   std::size_t number) const {
        const auto refused = [&] {
            return refuse(number, std::string(column.name) + " " + shown(text), std::string(column.expected));
        };
        if (column.kind == ColumnKind::word) {
            for (std::size_t word = 0; word < column.words.size(); ++word)
                if (column.words[word] == text)
                    return static_cast<double>(word);
            return refused();
        }
        double value = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value) ||
            value < column.least || value > column.most)
            return refused();
        if (column.kind == ColumnKind::integer && value != std::floor(value))
            return refused();
        return inSi(column.kind, value);
    }

    static double inSi(ColumnKind kind, double value) {
        switch (kind) {
        case ColumnKind::time:
            return onMicroseconds(value);
        case ColumnKind::length:
            return std::nearbyint(value * 1e6) / 1e9 +
                   0.0; // whole nm; the double nearest to the written decimal
        case ColumnKind::force:
            return onMillinewtons(value);
        case ColumnKind::angle:
            return core::radFromDeg(value);
        case ColumnKind::torque:
            return std::nearbyint(value * 1e2) / 1e5 + 0.0; // whole 0.01 mN·m, rounded as in trace_grid.h
        case ColumnKind::fineAngle:
            return core::radFromDeg(std::nearbyint(value * 1e6) / 1e6 + 0.0);
        case ColumnKind::number:
        case ColumnKind::integer:
        case ColumnKind::word:
            break;
        }
        return value;
    }

    core::Result<bool> accept(TraceRow& row) {
        double& last = m_lastTime[row.tool];
        if (!(row.t_s > last))
            return refuse(columnOf("t_s"), "t_s " + std::to_string(row.t_s),
                          "a time later than tool " + std::to_string(row.tool) + "'s last, " +
                              std::to_string(last) + " (to whole microseconds)");
        last = row.t_s;
        const double norm = row.q_WT.norm();
        if (std::abs(norm - 1.0) > 1e-3)
            return refuse(columnOf("qw"), "quaternion of length " + std::to_string(norm),
                          "length 1 to within 0.001");
        if (std::abs(norm - 1.0) > 1e-12) // already of unit length: keep the bits that were written
            row.q_WT.normalize();
        m_out.rows.push_back(row);
        return true;
    }

    std::size_t columnOf(std::string_view name) const {
        for (std::size_t i = 0; i < m_columns.size(); ++i)
            if (m_columns[i].fixed != nullptr && m_columns[i].fixed->name == name)
                return i + 1;
        return 1;
    }

    std::string_view m_text;
    std::span<const TraceColumn> m_known; ///< every column that a file may have, except named ones
    std::size_t m_line = 0;
    std::vector<Column> m_columns;
    std::array<double, 4> m_lastTime{};
    TraceRows m_out;
};

} // namespace

core::Result<TraceRows> readTraceCsv(std::string_view text, const std::string& name) {
    return readTraceCsv(text, name, traceColumns());
}

core::Result<TraceRows> readTraceCsv(std::string_view text, const std::string& name,
                                     std::span<const TraceColumn> known) {
    return Reader(text, name, known).read();
}

} // namespace chiron::scoring
