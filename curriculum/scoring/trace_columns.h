// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "scoring/trace_rows.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace chiron::scoring {

/// How a column's text maps to a value in a row. Reader and writer share this table.
enum class ColumnKind {
    time,   ///< s, whole µs in the file
    length, ///< mm, whole nm in the file
    force,  ///< N, whole mN in the file
    number, ///< any finite number, as the shortest decimals that read back to it
    angle,  ///< degrees in the file, rad here
    integer,
    word,      ///< one of TraceColumn::words; its number here
    torque,    ///< mN·m, whole 0.01 mN·m in the file
    fineAngle, ///< degrees, whole 1e-6° in the file, rad here
};

/// One column: its name, the group of columns that are all present or all absent, and where its value is
/// stored in a row.
struct TraceColumn {
    std::string_view name;
    ColumnKind kind = ColumnKind::number;
    bool TraceColumns::*group = nullptr; ///< null: always present, unless it has an owner
    double least = 0.0;                  ///< range in the file's unit, both ends included
    double most = 0.0;
    std::string_view expected;                    ///< for error messages
    double (*get)(const TraceRow& row) = nullptr; ///< SI; integers and words as numbers
    void (*set)(TraceRow& row, double value) = nullptr;
    std::span<const std::string_view> words{}; ///< for ColumnKind::word
    /// The columns of one exercise to which it belongs (then without group, get and set), and its place
    /// there.
    const OwnColumns* owner = nullptr;
    std::size_t place = 0;

    double valueIn(const TraceRow& row) const {
        if (owner == nullptr)
            return get(row);
        return place < row.own.size() ? row.own[place] : 0.0;
    }
    void setIn(TraceRow& row, double value) const {
        if (owner != nullptr)
            row.own[place] = value;
        else
            set(row, value);
    }
    bool presentIn(const TraceColumns& columns) const {
        return owner != nullptr ? columns.own == owner : group == nullptr || columns.*group;
    }
};

/// All columns in the order of a file, those of exercises included.
std::span<const TraceColumn> traceColumns();

/// Returns the position in traceColumns(), or -1.
int findTraceColumn(std::string_view name);

/// readTraceCsv() (trace_csv.h) of a file that may have the columns `known` instead of traceColumns(). They
/// must outlive the rows.
core::Result<TraceRows> readTraceCsv(std::string_view text, const std::string& name,
                                     std::span<const TraceColumn> known);

inline constexpr std::string_view kQuantityPrefix = "quantity_"; ///< + id: quantity of the scene,
                                                                 ///< core::QuantityDescription
inline constexpr std::string_view kTruthPrefix = "truth_";       ///< + id: ground truth of the trial,
                                                                 ///< NamedValue

/// Returns the id after the prefix in the name of a column that an exercise named: 1 to 64 letters, digits
/// and _. Empty for any other name.
std::string_view namedColumnId(std::string_view name, std::string_view prefix);

} // namespace chiron::scoring
