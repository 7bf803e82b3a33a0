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

/// The types that parameters have. An optional number may be left out.
using ParameterValue = std::variant<double, int, bool, std::uint64_t, std::string, std::optional<double>, std::vector<double>, StimulusGrids,
                                    std::vector<ParameterGrid>, OutcomeProbabilities>;

/// What the numbers of a parameter are, for those who show them in units that people think in.
enum class Quantity : std::uint8_t {
    plain,  ///< shown as it is stored
    share,  ///< 0 to 1; shown in per cent
    level,  ///< a place on x
    spread, ///< a distance on x
    factor, ///< a distance on a logarithm, whatever x is
    noise,  ///< log10 of the internal noise σ; shown as the just noticeable difference
};

/// One word that a parameter of text may be.
struct ParameterWord {
    std::string_view word;
    std::string_view title{}; ///< for people, English, marked; empty: never offered
};

/// What is told beside a field, in the unit that it shows: what is sensible, which is less than what is allowed.
struct SensibleRange {
    double lowest = 0.0;
    double highest = 0.0;
    std::optional<double> usual{}; ///< none: what a new procedure has in this condition
};

/// Numbers that a field takes and how they are written, in the unit that it shows.
struct FieldRange {
    double lowest = 0.0;
    double highest = 0.0;
    int decimals = 2;
    double step = 1.0;
};

constexpr double kUnbounded = 1e9; ///< what stands for "any number" in the limits of x

/// One parameter of a procedure: the row that the JSON reader and writer, the schema with its range checks, forms and reports are made of.
struct Parameter {
    std::string_view key{};            ///< in JSON
    std::string_view object{};         ///< key of the object that it lies in ("stop"); empty: of the procedure itself
    std::string_view unit = "1";       ///< as the schema says it: "1", "x", "1/x", "log10", ...
    Quantity quantity = Quantity::plain;
    double minimum = 0.0;              ///< of the number, or of each number in a list
    double maximum = kUnbounded;
    int fewest = 0;                    ///< of a list: items
    int most = 1000;
    std::vector<ParameterWord> words{}; ///< of a text: what it may be
    std::string_view description{};    ///< one sentence for the schema, which names kinds and default itself; plain English, not translated
    std::string_view item = "One number, in the procedure's unit."; ///< of a list: what one number is, likewise
    std::string_view byDefault{};      ///< what the schema says of the default where the value itself does not ("none")
    std::string_view noMoreThan{};     ///< key of the row beside it whose value it must not exceed, where that one is above 0
    bool ignored = false;              ///< read and kept, but without effect for this kind of procedure
    bool inTable = false;              ///< values must lie in the condition's table of differences, as they are presented

    // For people; English, marked with QT_TRANSLATE_NOOP (marked_texts.h). Without a meaning it is not asked: it follows from the condition.
    std::string_view title{};
    std::string_view meaning{};
    std::string_view meaningOfFactor{}; ///< where distances on x are factors; empty: the meaning
    std::string_view zero{};            ///< what the smallest value is called ("never"); empty: by its number
    std::string_view change{};          ///< what a change of it is called for undo; empty: a change of the procedure
    std::optional<SensibleRange> sensible{};
    std::optional<FieldRange> field{};  ///< empty: as its quantity has it
    std::optional<FieldRange> fieldOfFactor{}; ///< where distances on x are factors; empty: as field
    bool (*applies)(const ProcedureSpec& spec) = nullptr; ///< whether it is asked now; null: always
    bool (*asStored)(const ProcedureSpec& spec) = nullptr; ///< whether distances are in no unit of x, and so shown as they are stored; null: never
    /// The words that suit a condition, the usual one first; null: all of them.
    std::vector<std::string> (*wordsFor)(const Condition& condition) = nullptr;
    /// What depends on it follows a change; null: nothing does.
    void (*follow)(ProcedureSpec& spec, const Condition& condition) = nullptr;

    bool isAsked() const noexcept { return !meaning.empty(); }

    // Filled by rowOf(). The specification must be of the row's kind.
    std::function<ParameterValue(const ProcedureSpec& spec)> get{};
    std::function<void(ProcedureSpec& spec, const ParameterValue& value)> set{}; ///< the value must be of the type that get() returns
};

/// The row of one member of a specification.
template <class Spec, class Member> Parameter rowOf(Member Spec::*member, Parameter row) {
    row.get = [member](const ProcedureSpec& spec) -> ParameterValue { return std::get<Spec>(spec).*member; };
    row.set = [member](ProcedureSpec& spec, const ParameterValue& value) { std::get<Spec>(spec).*member = std::get<Member>(value); };
    return row;
}

/// Which rules of when to stop a procedure has a use for, and which of them a form asks for.
struct StopRows {
    bool reversals = false;          ///< it counts reversals
    bool reversalsAndTrials = false; ///< and can wait for both
    bool precision = false;          ///< it has a posterior: minimum trials and the sd that ends a run
    Quantity sd = Quantity::spread;
    bool asksReversals = false;
};

/// The rows of the object "stop". All kinds read every rule; those without effect are `ignored`.
std::vector<Parameter> stopRows(const StopRows& has, std::function<StopRule&(ProcedureSpec&)> rule);

template <class Spec> void addStopRows(std::vector<Parameter>& rows, const StopRows& has) {
    for (Parameter& row : stopRows(has, [](ProcedureSpec& spec) -> StopRule& { return std::get<Spec>(spec).stop; }))
        rows.push_back(std::move(row));
}

/// Where a number lies outside its row's range: "steps_up[1]: 1e+10: expected 1e-12 to 1e+09"; empty: nowhere. Lists of grids are left to
/// who makes the procedure.
std::string rangeFault(const Parameter& row, const ParameterValue& value);

} // namespace chiron::psychophysics
