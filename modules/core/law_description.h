// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <span>
#include <string>
#include <string_view>

namespace chiron::core {

/// A column of a law's table. The name carries its unit as the content's keys do, e.g. "px_m", "normal_force_N".
struct LawColumn {
    std::string_view name;
    std::string_view unit; ///< SI, for people: "m", "N/m"; "1" for pure numbers
};

/// A setting of a law that holds for the whole table.
struct LawParameter {
    std::string_view name;
    std::string_view unit;
    double defaultValue = 0.0;
    double minimum = 0.0; ///< inclusive
    double maximum = 0.0; ///< inclusive
    bool whole = false;   ///< a count, a seed or a switch: only whole numbers mean something
};

/// One law of models.md as a table over rows of numbers, for the command line's `evaluate`: nothing but data and one pure
/// function, so that each module can list its own without knowing who asks. All views have static storage.
struct LawDescription {
    /// One row: `parameters`, `inputs` and `outputs` have the lengths of the lists below, in their order. Stateless; the
    /// caller has checked the parameters' ranges and that inputs are finite.
    using EvaluateRow = void (*)(std::span<const double> parameters, std::span<const double> inputs,
                                 std::span<double> outputs) noexcept;
    /// Why the law does not hold for these values though each is in its range: which of them, what it found and what was expected, in one
    /// line; empty where it holds. Without `inputs` the parameters alone are judged, else both.
    using FindProblem = std::string (*)(std::span<const double> parameters, std::span<const double> inputs);

    std::string_view id;     ///< what `evaluate ID` takes, e.g. "friction", "urethra-force"
    std::string_view title;  ///< one line for people
    std::string_view source; ///< paper and equation, or models.md §
    std::span<const LawColumn> inputs;
    std::span<const LawColumn> outputs;
    std::span<const LawParameter> parameters;
    EvaluateRow evaluate = nullptr;
    FindProblem problem = nullptr; ///< null: it holds for all
};

/// "NAME VALUE: expected EXPECTED", as a problem of a law says it.
inline std::string lawProblem(std::string_view name, double value, std::string_view expected) {
    char number[32];
    std::snprintf(number, sizeof number, "%.6g", value);
    return std::string(name) + " " + number + ": expected " + std::string(expected);
}

} // namespace chiron::core
