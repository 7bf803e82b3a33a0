// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/marked_texts.h"
#include "core/random.h"
#include "psychophysics/procedures/procedure_kind.h"
#include "psychophysics/procedures/psychometric_functions.h"
#include "psychophysics/procedures/quest_plus.h"
#include "psychophysics/procedures/usual_levels.h"

#include <algorithm>

namespace chiron::psychophysics {

namespace {

/// Returns a default grid for a parameter of a function, given a table of levels.
ParameterGrid usualGrid(const std::string& parameter, const std::vector<double>& levels, double guess,
                        bool logarithm) {
    const double range = std::max(levels.back() - levels.front(), kSmallestDifference);
    if (parameter == "threshold" || parameter == "mean")
        return {parameter, evenGrid(levels.front(), levels.back(), 41), {}, false};
    if (parameter == "sd")
        return {parameter, evenGrid(0.05 * range, range, 9), {}, false};
    // The slope refers to a change in x, so for a table of D it depends on the table's range.
    if (parameter == "slope") {
        std::vector<double> slopes{1.5, 2.0, 3.0, 4.5, 7.0};
        for (double& slope : slopes)
            slope /= logarithm ? 1.0 : range;
        return {parameter, slopes, {}, false};
    }
    if (parameter == "lower_asymptote")
        return {parameter, {guess}, {}, false};
    return {parameter, {0.0, 0.02, 0.05}, {}, true};
}

std::vector<std::string> functionsFor(const Condition& condition) {
    if (condition.scale == ProcedureScale::logDifference)
        return {"weibull_log10", "norm_cdf", "logistic", "reverse_gumbel", "hyperbolic_secant"};
    return {"norm_cdf", "norm_cdf_2", "logistic", "hyperbolic_secant"};
}

/// Sets a grid for each parameter of the chosen function.
void takeGridsOfFunction(ProcedureSpec& of, const Condition& condition) {
    auto& spec = std::get<QuestPlusSpec>(of);
    const PsychometricFunction* known = psychometricFunction(spec.function);
    if (!known)
        return;
    const std::vector<double> levels = usualLevels(condition);
    spec.parameters.clear();
    for (const std::string_view name : known->parameters())
        spec.parameters.push_back(usualGrid(std::string(name), levels, guessRateOf(condition.task),
                                            condition.scale == ProcedureScale::logDifference));
}

Parameter functionRow() {
    return rowOf(&QuestPlusSpec::function,
                 {.key = "function",
                  .words = {{"weibull_db", QT_TRANSLATE_NOOP("Procedures", "Weibull")},
                            {"weibull_log10", QT_TRANSLATE_NOOP("Procedures", "Weibull")},
                            {"weibull", QT_TRANSLATE_NOOP("Procedures", "Weibull")},
                            {"norm_cdf", QT_TRANSLATE_NOOP("Procedures", "Normal (probit)")},
                            {"norm_cdf_2", QT_TRANSLATE_NOOP("Procedures", "Normal, lapses on both sides")},
                            {"logistic", QT_TRANSLATE_NOOP("Procedures", "Logistic (logit)")},
                            {"gumbel", QT_TRANSLATE_NOOP("Procedures", "Gumbel")},
                            {"reverse_gumbel", QT_TRANSLATE_NOOP("Procedures", "Gumbel, mirrored")},
                            {"hyperbolic_secant", QT_TRANSLATE_NOOP("Procedures", "Hyperbolic secant")},
                            {"csf"},
                            {"table"}},
                  .description =
                      "psi = lower_asymptote + (1 - lower_asymptote - lapse_rate) F. F and its parameters: "
                      "weibull_db 1-exp(-10^(slope(x-threshold)/20)); "
                      "weibull_log10 and gumbel 1-exp(-10^(slope(x-threshold))); weibull "
                      "1-exp(-(x/threshold)^slope); norm_cdf Phi((x-mean)/sd); logistic "
                      "1/(1+exp(-slope(x-threshold))); reverse_gumbel exp(-10^(-slope(x-threshold))); "
                      "hyperbolic_secant 2/pi atan(exp(pi/2 slope(x-threshold))); "
                      "csf weibull_db over contrast, spatial_freq, temporal_freq with threshold "
                      "max(min_thresh, c0+cf f+cw w), parameters min_thresh, c0, cf, cw, "
                      "slope. norm_cdf_2: lapse_rate + (1 - 2 lapse_rate) Phi((x-mean)/sd). table: the "
                      "probabilities themselves.",
                  .title = QT_TRANSLATE_NOOP("Procedures", "Psychometric function"),
                  .meaning = QT_TRANSLATE_NOOP(
                      "Procedures", "How the share of right answers is assumed to grow with the difference."),
                  .change = QT_TRANSLATE_NOOP("Procedures", "Change of the function"),
                  .wordsFor = functionsFor,
                  .follow = takeGridsOfFunction});
}

std::vector<Parameter> questPlusRows() {
    using Spec = QuestPlusSpec;
    std::vector<Parameter> rows{
        functionRow(),
        rowOf(&Spec::repeatLimit,
              {.key = "repeat_limit",
               .maximum = 1000,
               .description =
                   "the same stimulus, in whatever rows it is given, at most this often in a row; 0 "
                   "as often as it is best.",
               .title = QT_TRANSLATE_NOOP("Procedures", "Same difference in a row"),
               .meaning = QT_TRANSLATE_NOOP(
                   "Procedures",
                   "The same difference is presented at most this many times in a row; 0: no limit."),
               .usual = UsualValue{}}),
        rowOf(&Spec::catchEvery,
              {.key = "catch_every",
               .quantity = Quantity::share,
               .maximum = 0.99,
               .description = "share of trials at the easiest stimulus, drawn.",
               .title = QT_TRANSLATE_NOOP("Procedures", "Catch trials"),
               .meaning = QT_TRANSLATE_NOOP("Procedures", "Share of trials with the largest difference, "
                                                          "which show whether a participant pays attention."),
               .usual = UsualValue{0}})};
    addStopRows<Spec>(rows, {.precision = true});
    std::vector<Parameter> rest{
        rowOf(&Spec::parameters,
              {.key = "parameters",
               .unit = "x",
               .minimum = -kUnbounded,
               .fewest = 1,
               .most = 12,
               .description = "the grid of every parameter of the function, lower_asymptote (not of "
                              "norm_cdf_2) and lapse_rate among them; in any order "
                              "(with a table: the order of its cells, nuisance ones last).",
               .item = "One parameter.",
               .meaning = QT_TRANSLATE_NOOP("Procedures",
                                            "Values of this parameter that are considered possible.")}),
        rowOf(&Spec::stimuli, {.key = "stimuli",
                               .unit = "x",
                               .minimum = -kUnbounded,
                               .fewest = 1,
                               .most = 8,
                               .description = "the dimensions of the stimulus; all combinations are "
                                              "candidates, the first dimension outermost.",
                               .item = "One dimension."}),
        rowOf(
            &Spec::outcomes,
            {.key = "outcomes", .minimum = 2, .maximum = 64, .description = "how many; 2 but for a table."}),
        rowOf(&Spec::seed, {.key = "seed",
                            .maximum = 9007199254740992.0,
                            .description = "of which trials are catch trials."}),
        rowOf(&Spec::table,
              {.key = "table",
               .maximum = 1,
               .fewest = 2,
               .most = 64,
               .description = "with function table: probabilities [outcome][stimulus][parameter cell]; over "
                              "outcomes they sum to 1. Cells run through the "
                              "parameters, the first outermost.",
               .item = "A probability."})};
    for (Parameter& row : rest)
        rows.push_back(std::move(row));
    return rows;
}

class QuestPlusKind final : public ProcedureKindOf<QuestPlusSpec> {
public:
    QuestPlusKind()
        : ProcedureKindOf(
              {QT_TRANSLATE_NOOP("Procedures", "QUEST+"),
               QT_TRANSLATE_NOOP(
                   "Procedures",
                   "Bayesian; chooses the trial that tells most about threshold, slope and lapse rate.")},
              questPlusRows()) {}

    core::Result<ProcedureFactory> factory(const ProcedureSpec& spec) const override {
        return factoryOfModel(questPlusModel(ours(spec)), std::to_string(ours(spec).seed));
    }

    /// Returns a specification with a threshold in logarithms of D (Weibull) or, if the transition is between
    /// yes and no, on the scale of D itself (normal).
    ProcedureSpec usual(const Condition& condition) const override {
        QuestPlusSpec spec;
        spec.stimuli = {{"x", usualLevels(condition)}};
        spec.function = functionsFor(condition).front();
        ProcedureSpec usual = spec;
        takeGridsOfFunction(usual, condition);
        return usual;
    }

    bool drives(Task task) const override { return isRightOrWrong(task) || ranksThree(task); }
    int recommended(Task task) const override {
        return isForcedChoice(task) ? 5 : isRightOrWrong(task) ? 3 : 0;
    }
    std::optional<TaskFault> faultFor(const ProcedureSpec& spec, Task task) const override {
        if (ours(spec).outcomes == outcomes(task))
            return std::nullopt;
        return TaskFault{"outcomes", "another number",
                         std::to_string(outcomes(task)) + " for the task " + std::string(token(task))};
    }
    bool ordersThree(const ProcedureSpec& spec) const override { return ours(spec).function == "rank3"; }
};

} // namespace

const ProcedureKind& QuestPlusSpec::kind() {
    static const QuestPlusKind kind;
    return kind;
}

} // namespace chiron::psychophysics
