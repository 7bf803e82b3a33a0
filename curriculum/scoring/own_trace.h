// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace chiron::scoring {

enum class ColumnKind;
struct TraceColumns;
struct TraceRow;

/// How far the tip came along a line that it has to follow, sample by sample of tool 0.
struct WayAlongLine {
    std::span<const double> s_m;         ///< arc length
    std::span<const std::uint8_t> part;  ///< the part of the trial
    std::span<const std::uint8_t> parts; ///< those in which it follows the line, in their order
};

/// A column of a trace file that one exercise has; see TraceColumn.
struct OwnColumn {
    std::string_view name;
    ColumnKind kind;
    double least = 0.0; ///< range in the file's unit, both ends included
    double most = 0.0;
    std::string_view expected;                 ///< for error messages
    std::string_view after;                    ///< the shared column that it follows in a file
    bool ofTrial = false;                      ///< the same on each row of a trial
    std::span<const std::string_view> words{}; ///< for ColumnKind::word
};

class OwnTrace;

/// The columns of a trace file that one exercise has: all of them are present or none. Static data.
struct OwnColumns {
    std::string_view of; ///< what they describe, for error messages: "a canal"
    std::span<const OwnColumn> columns;
    bool TraceColumns::*required = nullptr; ///< shared columns that a file must have beside them
    bool withTorque = false; ///< an exported file also has the torque about the tip, if that was recorded
    /// Makes the value of a trial from its rows of tool 0 (TraceRow::own, in the order of `columns`); `first`
    /// is the trial's first row.
    std::shared_ptr<const OwnTrace> (*make)(const TraceRow& first,
                                            std::span<const TraceRow* const> rows) = nullptr;
};

/// What one exercise knows of a trial beside poses, forces and quantities: series with a value for each
/// sample of tool 0, and values of the trial. It is derived from stored poses and wrenches by the exercise
/// (ExerciseKind::addTruth), or read from a trace file's columns. A value type of the exercise, immutable
/// once it is in a trial.
class OwnTrace {
public:
    virtual ~OwnTrace() = default;
    /// Returns whether each series has `samples` values.
    virtual bool fits(std::size_t samples) const noexcept = 0;
    /// Returns whether all values of sample `i` are finite.
    virtual bool finiteAt(std::size_t i) const noexcept = 0;
    /// Returns the samples `kept`, whose times are `t_s`, with every value on the grid of its column.
    /// Errors: what a trace file cannot hold.
    virtual core::Result<std::shared_ptr<const OwnTrace>> onGrids(std::span<const std::size_t> kept,
                                                                  std::span<const double> t_s) const = 0;
    virtual const OwnColumns& columns() const noexcept = 0;
    /// Sets the values of the trial in TraceRow::own, and those of sample `i`, taken at `t_s`.
    virtual void fillTrial(std::span<double> own) const noexcept = 0;
    virtual void fillSample(std::span<double> own, std::size_t i, double t_s) const noexcept = 0;
    /// The line that the tip has to follow; empty if there is none.
    virtual WayAlongLine way() const noexcept { return {}; }

protected:
    OwnTrace() = default;
    OwnTrace(const OwnTrace&) = default;
    OwnTrace& operator=(const OwnTrace&) = default;
};

/// The columns of all exercises that have columns of their own. own_column_catalogue.cpp lists them.
std::span<const OwnColumns* const> ownColumns() noexcept;

} // namespace chiron::scoring
