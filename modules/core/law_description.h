// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
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
};

/// One law of models.md as a table over rows of numbers, for the command line's `evaluate`: nothing but data and one pure
/// function, so that each module can list its own without knowing who asks. All views have static storage.
struct LawDescription {
    /// One row: `parameters`, `inputs` and `outputs` have the lengths of the lists below, in their order. Stateless; the
    /// caller has checked the parameters' ranges and that inputs are finite.
    using EvaluateRow = void (*)(std::span<const double> parameters, std::span<const double> inputs,
                                 std::span<double> outputs) noexcept;

    std::string_view id;     ///< what `evaluate ID` takes, e.g. "friction", "urethra-force"
    std::string_view title;  ///< one line for people
    std::string_view source; ///< paper and equation, or models.md §
    std::span<const LawColumn> inputs;
    std::span<const LawColumn> outputs;
    std::span<const LawParameter> parameters;
    EvaluateRow evaluate = nullptr;
};

} // namespace chiron::core
