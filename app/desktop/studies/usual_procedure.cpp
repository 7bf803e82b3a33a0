// SPDX-License-Identifier: GPL-3.0-or-later
// Procedures as somebody would begin with who chooses their kind.
#include "desktop/studies/procedure_form.h"

#include "psychophysics/procedures/psychometric_functions.h"

#include <algorithm>
#include <cmath>

namespace chiron::desktop {

using namespace psychophysics;

namespace {

constexpr double kSmallest = 1e-4; // of a difference that a logarithm is taken of

/// The table in the scale of the procedure's x, ascending.
std::vector<double> levelsOf(const Condition& condition) {
    std::vector<double> levels;
    for (const double difference : condition.stimulus.differences) {
        if (condition.scale == ProcedureScale::difference)
            levels.push_back(difference);
        else if (difference > kSmallest)
            levels.push_back(std::log10(difference));
    }
    if (levels.empty())
        levels.push_back(condition.scale == ProcedureScale::difference ? 0.1 : -1.0);
    return levels;
}

double guessOf(Task task) {
    switch (task) {
    case Task::threeAfc:
    case Task::oddity:
        return 1.0 / 3.0;
    case Task::twoAfc:
        return 0.5;
    case Task::rank3:
    case Task::rank3Ties:
        return 1.0 / 6.0;
    case Task::sameDifferent:
    case Task::yesNo:
    case Task::adjustment:
    case Task::magnitude:
        break;
    }
    return 0.0;
}

/// `count` values from `low` to `high`, both included.
std::vector<double> grid(double low, double high, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
        values.push_back(low + (high - low) * i / std::max(1, count - 1));
    return values;
}

/// At most `most` of the values, evenly taken, the ends included.
std::vector<double> someOf(const std::vector<double>& values, std::size_t most) {
    if (values.size() <= most)
        return values;
    std::vector<double> some;
    for (std::size_t i = 0; i < most; ++i)
        some.push_back(values[i * (values.size() - 1) / (most - 1)]);
    return some;
}

/// What each parameter of a function may be, for a table of levels.
ParameterGrid usualGrid(const std::string& parameter, const std::vector<double>& levels, double guess, bool logarithm) {
    const double range = std::max(levels.back() - levels.front(), kSmallest);
    if (parameter == "threshold" || parameter == "mean")
        return {parameter, grid(levels.front(), levels.back(), 41), {}, false};
    if (parameter == "sd")
        return {parameter, grid(0.05 * range, range, 9), {}, false};
    if (parameter == "slope") { // of a change in x: a table of D is as wide as its range
        std::vector<double> slopes{1.5, 2.0, 3.0, 4.5, 7.0};
        for (double& slope : slopes)
            slope /= logarithm ? 1.0 : range;
        return {parameter, slopes, {}, false};
    }
    if (parameter == "lower_asymptote")
        return {parameter, {guess}, {}, false};
    return {parameter, {0.0, 0.02, 0.05}, {}, true};
}

/// A threshold in logarithms of D (Weibull), or where yes and no are alike likely on the scale of D itself (normal).
QuestPlusSpec usualQuestPlus(const Condition& condition, const std::vector<double>& levels) {
    QuestPlusSpec spec;
    spec.stimuli = {{"x", levels}};
    takeFunction(spec, functionsFor(condition.scale).front(), condition);
    return spec;
}

Rank3Spec usualRank3(const std::vector<double>& levels, Task task) {
    Rank3Spec spec;
    spec.allowTies = task == Task::rank3Ties;
    spec.differences = levels;
    spec.differences.erase(std::remove_if(spec.differences.begin(), spec.differences.end(), [](double d) { return d <= 0.0; }), spec.differences.end());
    const double largest = spec.differences.empty() ? 0.2 : spec.differences.back();
    const double smallest = spec.differences.empty() ? 0.005 : spec.differences.front();
    spec.log10Sigma = grid(std::log10(smallest / 3.0), std::log10(largest), 41);
    return spec;
}

/// 1-up/3-down with García-Pérez's ratio of steps: converges at 83.15 %.
StaircaseSpec usualStaircase(const std::vector<double>& levels) {
    constexpr double kRatioOfThreeDown = 0.7393;
    StaircaseSpec spec;
    spec.start = levels.back();
    spec.stepRatio = kRatioOfThreeDown;
    spec.minimum = levels.front();
    spec.maximum = levels.back();
    return spec;
}

} // namespace

std::vector<std::string> kindsFor(Task task) {
    switch (task) {
    case Task::rank3:
    case Task::rank3Ties:
        return {"rank3_quest_plus", "descending", "constant"};
    case Task::adjustment:
    case Task::magnitude:
        return {"constant"};
    case Task::sameDifferent:
    case Task::yesNo:
        return {"constant", "quest_plus", "quest", "staircase"};
    case Task::twoAfc:
    case Task::threeAfc:
    case Task::oddity:
        break;
    }
    return {"quest_plus", "staircase", "quest", "constant", "pest"};
}

ProcedureSpec usualProcedure(const std::string& kind, const Condition& condition) {
    const std::vector<double> levels = levelsOf(condition);
    if (kind == "staircase")
        return usualStaircase(levels);
    if (kind == "pest") {
        PestSpec spec;
        spec.start = spec.maximum = levels.back();
        spec.minimum = levels.front();
        return spec;
    }
    if (kind == "constant") {
        ConstantSpec spec;
        spec.levels = someOf(levels, 7);
        return spec;
    }
    if (kind == "descending") {
        std::vector<double> falling = someOf(levels, 12);
        std::reverse(falling.begin(), falling.end());
        DescendingSpec spec;
        spec.levels = falling;
        return spec;
    }
    if (kind == "quest") {
        QuestSpec spec;
        spec.priorMean = levels[levels.size() / 2];
        spec.guess = guessOf(condition.task);
        spec.minimum = levels.front();
        spec.maximum = levels.back();
        return spec;
    }
    if (kind == "rank3_quest_plus")
        return usualRank3(levels, condition.task);
    return usualQuestPlus(condition, levels);
}

std::vector<std::string> functionsFor(ProcedureScale scale) {
    if (scale == ProcedureScale::logDifference)
        return {"weibull_log10", "norm_cdf", "logistic", "reverse_gumbel", "hyperbolic_secant"};
    return {"norm_cdf", "norm_cdf_2", "logistic", "hyperbolic_secant"};
}

void takeFunction(QuestPlusSpec& spec, const std::string& function, const Condition& condition) {
    const PsychometricFunction* known = psychometricFunction(function);
    if (!known)
        return;
    const std::vector<double> levels = levelsOf(condition);
    spec.function = function;
    spec.parameters.clear();
    for (const std::string_view name : known->parameters())
        spec.parameters.push_back(usualGrid(std::string(name), levels, guessOf(condition.task), condition.scale == ProcedureScale::logDifference));
}

} // namespace chiron::desktop
