// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "psychophysics/procedures/procedure_spec.h"

namespace chiron::psychophysics {

struct Condition;

/// The types that a parameter can have. An optional number may be left out.
using ParameterValue =
    std::variant<double, int, bool, std::uint64_t, std::string, std::optional<double>, std::vector<double>,
                 StimulusGrids, std::vector<ParameterGrid>, OutcomeProbabilities>;

/// What the numbers of a parameter mean, so that a user interface can show them in familiar units.
enum class Quantity : std::uint8_t {
    plain,  ///< shown as it is stored
    share,  ///< 0 to 1; shown in per cent
    level,  ///< a position on x
    spread, ///< a distance on x
    factor, ///< a distance on a logarithmic scale, whatever the scale of x
    noise,  ///< log10 of the internal noise σ; shown as the just noticeable difference
};

/// One word that a text parameter may have as its value.
struct ParameterWord {
    std::string_view word;
    std::string_view title{}; ///< for people; English, marked for translation; empty: never offered
};

/// The usual value, which is shown beside a field together with the allowed range, in the field's unit. It is
/// the one that a new procedure begins with, so that a field never stands beside another number.
struct UsualValue {
    std::optional<double> value{}; ///< none: the value that a new procedure has in this condition
};

/// The numbers that a field accepts and how they are written, in the field's unit.
struct FieldRange {
    double lowest = 0.0;
    double highest = 0.0;
    int decimals = 2;
    double step = 1.0;
};

constexpr double kUnbounded = 1e9; ///< stands for "any number" in the limits of x

/// Describes one parameter of a procedure. The JSON reader and writer, the schema with its range checks,
/// forms and reports are all generated from such rows.
struct Parameter {
    std::string_view key{};      ///< in JSON
    std::string_view object{};   ///< key of the object that contains it ("stop"); empty: the procedure
                                 ///< itself
    std::string_view unit = "1"; ///< as in the schema: "1", "x", "1/x", "log10", ...
    Quantity quantity = Quantity::plain;
    double minimum = 0.0; ///< of the number, or of each number in a list
    double maximum = kUnbounded;
    int fewest = 0; ///< for a list: number of items
    int most = 1000;
    std::vector<ParameterWord> words{}; ///< for a text: the allowed words
    /// One sentence for the schema, which itself adds kinds and default. Plain English, not translated.
    std::string_view description{};
    /// For a list: what one number is, likewise.
    std::string_view item = "One number, in the procedure's unit.";
    /// Description of the default in the schema where the value itself is not descriptive ("none").
    std::string_view byDefault{};
    /// Key of the sibling row whose value this one must not exceed, if that value is above 0.
    std::string_view noMoreThan{};
    bool ignored = false; ///< read and kept, but without effect for this kind of procedure
    /// Values must lie within the condition's table of differences, because they are presented.
    bool inTable = false;

    // For people; English, marked with QT_TRANSLATE_NOOP (marked_texts.h). A parameter without a meaning is
    // not asked for: it follows from the condition.
    std::string_view title{};
    std::string_view meaning{};
    std::string_view meaningOfFactor{}; ///< used where distances on x are factors; empty: as meaning
    std::string_view zero{};            ///< name of the smallest value ("never"); empty: shown as a number
    std::string_view change{};          ///< name of a change for undo; empty: a change of the procedure
    std::optional<UsualValue> usual{};  ///< empty: neither it nor the range is shown
    std::optional<FieldRange> field{};  ///< empty: as its quantity prescribes
    std::optional<FieldRange> fieldOfFactor{}; ///< used where distances on x are factors; empty: as field
    bool (*applies)(const ProcedureSpec& spec) = nullptr; ///< whether it is asked for now; null: always
    /// Whether distances are not in the unit of x and are therefore shown as stored; null: never.
    bool (*asStored)(const ProcedureSpec& spec) = nullptr;
    /// Returns the words that suit a condition, the default first; null: all of them.
    std::vector<std::string> (*wordsFor)(const Condition& condition) = nullptr;
    /// Updates the parameters that depend on this one after a change; null: none do.
    void (*follow)(ProcedureSpec& spec, const Condition& condition) = nullptr;

    bool isAsked() const noexcept { return !meaning.empty(); }

    // Filled in by rowOf(). The specification must be of the row's kind.
    std::function<ParameterValue(const ProcedureSpec& spec)> get{};
    /// The value must have the type that get() returns.
    std::function<void(ProcedureSpec& spec, const ParameterValue& value)> set{};
};

/// Returns the row of one member of a specification.
template <class Spec, class Member> Parameter rowOf(Member Spec::*member, Parameter row) {
    row.get = [member](const ProcedureSpec& spec) -> ParameterValue { return std::get<Spec>(spec).*member; };
    row.set = [member](ProcedureSpec& spec, const ParameterValue& value) {
        std::get<Spec>(spec).*member = std::get<Member>(value);
    };
    return row;
}

/// Says which stop rules a procedure uses, and which of them a form asks for.
struct StopRows {
    bool reversals = false;          ///< the procedure counts reversals
    bool reversalsAndTrials = false; ///< it can also wait for both reversals and trials
    bool precision = false;          ///< it has a posterior: minimum number of trials, and the sd that ends a
                                     ///< run
    Quantity sd = Quantity::spread;
    bool asksReversals = false;
};

/// Returns the rows of the object "stop". All kinds read every rule; those without effect are `ignored`.
std::vector<Parameter> stopRows(const StopRows& has, std::function<StopRule&(ProcedureSpec&)> rule);

template <class Spec> void addStopRows(std::vector<Parameter>& rows, const StopRows& has) {
    for (Parameter& row :
         stopRows(has, [](ProcedureSpec& spec) -> StopRule& { return std::get<Spec>(spec).stop; }))
        rows.push_back(std::move(row));
}

/// Returns where a number lies outside its row's range: "steps_up[1]: 1e+10: expected 1e-12 to 1e+09"; empty
/// if none does. Lists of grids are checked by the code that makes the procedure.
std::string rangeFault(const Parameter& row, const ParameterValue& value);

} // namespace chiron::psychophysics
