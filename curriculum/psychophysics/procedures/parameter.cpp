// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/procedures/parameter.h"

#include "core/marked_texts.h"

#include <cstdio>

namespace chiron::psychophysics {

namespace {

constexpr double kMostTrialsOfStop = 1e6;

using RuleOf = std::function<StopRule&(ProcedureSpec&)>;

template <class Member> Parameter stopRow(const RuleOf& rule, Member StopRule::*member, Parameter row) {
    row.object = "stop";
    row.get = [rule, member](const ProcedureSpec& spec) -> ParameterValue {
        ProcedureSpec copy = spec; // `rule` needs a specification that is not const
        return rule(copy).*member;
    };
    row.set = [rule, member](ProcedureSpec& spec, const ParameterValue& value) {
        rule(spec).*member = std::get<Member>(value);
    };
    return row;
}

std::string shortNumber(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

/// Checks numbers against the range of their row.
struct RangeCheck {
    const Parameter& row;

    std::string one(double value, const std::string& place) const {
        if (value >= row.minimum && value <= row.maximum)
            return {};
        return std::string(row.key) + place + ": " + shortNumber(value) + ": expected " +
               shortNumber(row.minimum) + " to " + shortNumber(row.maximum);
    }
    std::string operator()(double value) const { return one(value, {}); }
    std::string operator()(int value) const { return one(value, {}); }
    std::string operator()(std::uint64_t value) const { return one(static_cast<double>(value), {}); }
    std::string operator()(const std::optional<double>& value) const {
        return value ? one(*value, {}) : std::string();
    }
    std::string operator()(const std::string& value) const {
        for (const ParameterWord& word : row.words)
            if (word.word == value)
                return {};
        return std::string(row.key) + ": \"" + value + "\": expected another word";
    }
    std::string operator()(const std::vector<double>& values) const {
        const auto count = static_cast<int>(values.size());
        if (count < row.fewest || count > row.most)
            return std::string(row.key) + ": " + std::to_string(count) + " numbers: expected " +
                   std::to_string(row.fewest) + " to " + std::to_string(row.most);
        for (std::size_t i = 0; i < values.size(); ++i)
            if (std::string fault = one(values[i], "[" + std::to_string(i) + "]"); !fault.empty())
                return fault;
        return {};
    }
    // Switches, grids and tables have no range.
    template <class Other> std::string operator()(const Other&) const { return {}; }
};

} // namespace

std::vector<Parameter> stopRows(const StopRows& has, std::function<StopRule&(ProcedureSpec&)> rule) {
    std::vector<Parameter> rows;
    rows.push_back(stopRow(rule, &StopRule::trials,
                           {.key = "trials",
                            .maximum = kMostTrialsOfStop,
                            .description = "at most this many scored trials.",
                            .title = QT_TRANSLATE_NOOP("Procedures", "Maximum trials"),
                            .meaning = QT_TRANSLATE_NOOP(
                                "Procedures", "The run ends after this number of trials at the latest; 0: no "
                                              "limit. With fewer than 20 trials, runs are marked as short, "
                                              "and many give no usable value."),
                            .usual = UsualValue{}}));
    Parameter reversals{.key = "reversals",
                        .maximum = kMostTrialsOfStop,
                        .description = "this many reversals.",
                        .ignored = !has.reversals};
    if (has.asksReversals) {
        reversals.title = QT_TRANSLATE_NOOP("Procedures", "Reversals until stop");
        reversals.meaning =
            QT_TRANSLATE_NOOP("Procedures", "The run ends once the direction has changed this many times; 0: "
                                            "only the number of trials ends it.");
        reversals.usual = UsualValue{};
    }
    rows.push_back(stopRow(rule, &StopRule::reversals, reversals));
    Parameter fewest{.key = "minimum_trials",
                     .maximum = kMostTrialsOfStop,
                     .description = "never before this many; at most as many as trials.",
                     .noMoreThan = "trials"};
    Parameter sd{.key = "sd",
                 .unit = "x",
                 .quantity = has.sd,
                 .description = "posterior sd of the first parameter at most.",
                 .ignored = !has.precision};
    if (has.precision) {
        fewest.title = QT_TRANSLATE_NOOP("Procedures", "Minimum trials");
        fewest.meaning = QT_TRANSLATE_NOOP(
            "Procedures", "The run does not end earlier, however sure the estimate is; 0: no minimum. It "
                          "matters only where the run stops at a set precision.");
        fewest.usual = UsualValue{}; // 20 for rankings; others end by their number of trials alone
        sd.title = QT_TRANSLATE_NOOP("Procedures", "Stop at this precision");
        sd.meaning = QT_TRANSLATE_NOOP(
            "Procedures",
            "The run ends once the threshold is known within this difference (one standard deviation).");
        sd.meaningOfFactor =
            QT_TRANSLATE_NOOP("Procedures", "The run ends once the threshold is known within this factor "
                                            "(one standard deviation). Usually × 1.15.");
        sd.zero = QT_TRANSLATE_NOOP("Procedures", "never");
        sd.fieldOfFactor = FieldRange{1.0, 100.0, 3, 0.01};
    }
    rows.push_back(stopRow(rule, &StopRule::minimumTrials, fewest));
    rows.push_back(stopRow(rule, &StopRule::sd, sd));
    rows.push_back(stopRow(rule, &StopRule::reversalsAndTrials,
                           {.key = "reversals_and_trials",
                            .description = "trials and reversals must both be reached.",
                            .ignored = !has.reversalsAndTrials}));
    return rows;
}

std::string rangeFault(const Parameter& row, const ParameterValue& value) {
    return std::visit(RangeCheck{row}, value);
}

} // namespace chiron::psychophysics
