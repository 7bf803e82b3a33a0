// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <span>
#include <string>
#include <string_view>

namespace chiron::core {

/// A column of a law's table. Its name carries the unit, as content keys do, e.g. "px_m", "normal_force_N".
struct LawColumn {
    std::string_view name;
    std::string_view unit; ///< SI, for people: "m", "N/m"; "1" for pure numbers
};

/// A parameter of a law that is the same for all rows of the table.
struct LawParameter {
    std::string_view name;
    std::string_view unit;
    double defaultValue = 0.0;
    double minimum = 0.0; ///< inclusive
    double maximum = 0.0; ///< inclusive
    bool whole = false;   ///< a count, a seed or a switch: only whole numbers are valid
};

/// One law of models.md as a function of table rows, for the command line's `evaluate`. It consists of data
/// and pure functions, so that each module can list its laws without knowing the caller. All views have
/// static storage.
struct LawDescription {
    /// Computes one row. `parameters`, `inputs` and `outputs` have the lengths of the lists below and the
    /// same order. Stateless; the caller has checked the parameters' ranges and that the inputs are finite.
    using EvaluateRow = void (*)(std::span<const double> parameters, std::span<const double> inputs,
                                 std::span<double> outputs) noexcept;
    /// Returns the reason why the law does not hold for these values although each is in its range: which
    /// value, what was found and what was expected, in one line; empty if the law holds. Empty `inputs` means
    /// that only the parameters are checked.
    using FindProblem = std::string (*)(std::span<const double> parameters, std::span<const double> inputs);

    std::string_view id;     ///< the ID for `evaluate ID`, e.g. "friction", "urethra-force"
    std::string_view title;  ///< one line for people
    std::string_view source; ///< paper and equation, or models.md §
    std::span<const LawColumn> inputs;
    std::span<const LawColumn> outputs;
    std::span<const LawParameter> parameters;
    EvaluateRow evaluate = nullptr;
    FindProblem problem = nullptr; ///< null: the law holds for all values in range
};

/// Formats a law's problem as "NAME VALUE: expected EXPECTED".
inline std::string lawProblem(std::string_view name, double value, std::string_view expected) {
    char number[32];
    std::snprintf(number, sizeof number, "%.6g", value);
    return std::string(name) + " " + number + ": expected " + std::string(expected);
}

} // namespace chiron::core
