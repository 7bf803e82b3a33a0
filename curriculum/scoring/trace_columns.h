// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/trace_rows.h"

#include <cstdint>
#include <span>
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
    phase,     ///< idle, ready, running, between, finished
    torque,    ///< mN·m, whole 0.01 mN·m in the file
    fineAngle, ///< degrees, whole 1e-6° in the file, rad here
    stage,     ///< outside, insertion, inspection, withdrawal, completed
};

/// One column: its name, the group of columns that are all present or all absent, and where its value is
/// stored in a row.
struct TraceColumn {
    std::string_view name;
    ColumnKind kind = ColumnKind::number;
    bool TraceColumns::*group = nullptr; ///< null: always present
    double least = 0.0;                  ///< range in the file's unit, both ends included
    double most = 0.0;
    std::string_view expected;                    ///< for error messages
    double (*get)(const TraceRow& row) = nullptr; ///< SI; integers and phases as numbers
    void (*set)(TraceRow& row, double value) = nullptr;
};

std::span<const TraceColumn> traceColumns();

/// Returns the position in traceColumns(), or -1.
int findTraceColumn(std::string_view name);

inline constexpr std::string_view kQuantityPrefix = "quantity_"; ///< + id: quantity of the scene,
                                                                 ///< core::QuantityDescription
inline constexpr std::string_view kTruthPrefix = "truth_";       ///< + id: ground truth of the trial,
                                                                 ///< NamedValue

/// Returns the id after the prefix in the name of a column that an exercise named: 1 to 64 letters, digits
/// and _. Empty for any other name.
std::string_view namedColumnId(std::string_view name, std::string_view prefix);

std::string_view phaseName(core::TrialPhase phase);
std::string_view stageName(core::ProcedureStage stage);

} // namespace chiron::scoring
