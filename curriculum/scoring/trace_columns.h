// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/trace_rows.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace chiron::scoring {

/// How a column's text maps to a row: one table for the reader and the writer.
enum class ColumnKind {
    time,   ///< s, whole µs in the file
    length, ///< mm, whole nm in the file
    force,  ///< N, whole mN in the file
    number, ///< any finite number, shortest decimals that read back alike
    angle,  ///< degrees in the file, rad here
    integer,
    phase,     ///< idle, ready, running, between, finished
    torque,    ///< mN·m, whole 0.01 mN·m in the file
    fineAngle, ///< degrees, whole 1e-6° in the file, rad here
    stage,     ///< outside, insertion, inspection, withdrawal, completed
};

/// One column: its name, the group that comes or stays away together, and where its value lives in a row.
struct TraceColumn {
    std::string_view name;
    ColumnKind kind = ColumnKind::number;
    bool TraceColumns::*group = nullptr; ///< null: always there
    double least = 0.0;                  ///< range in the file's unit, both ends included
    double most = 0.0;
    std::string_view expected;                    ///< for messages
    double (*get)(const TraceRow& row) = nullptr; ///< SI; integers and phases as numbers
    void (*set)(TraceRow& row, double value) = nullptr;
};

std::span<const TraceColumn> traceColumns();

/// Position in traceColumns(), or -1.
int findTraceColumn(std::string_view name);

inline constexpr std::string_view kQuantityPrefix = "quantity_"; ///< + id: of the scene, core::QuantityDescription
inline constexpr std::string_view kTruthPrefix = "truth_";       ///< + id: of the trial, NamedValue

/// The id behind the prefix of a column that an exercise named: letters, digits and _, 1 to 64 of them; empty for any other.
std::string_view namedColumnId(std::string_view name, std::string_view prefix);

std::string_view phaseName(core::TrialPhase phase);
std::string_view stageName(core::ProcedureStage stage);

} // namespace chiron::scoring
