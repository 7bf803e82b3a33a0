// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/procedures/quest_plus.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace chiron::psychophysics {

using core::ErrorCode;
using core::fail;

namespace {

constexpr std::size_t kMostStimuli = 65'536;
constexpr std::size_t kMostEntries = 200'000'000; ///< stimuli times cells

/// Returns all combinations, with the first dimension outermost.
core::Result<std::vector<Stimulus>> stimuliOf(const QuestPlusSpec& spec) {
    if (spec.stimuli.empty())
        return fail(ErrorCode::badInput, "stimuli: expected at least one dimension");
    std::vector<Stimulus> stimuli{{}};
    for (const auto& [name, values] : spec.stimuli) {
        if (values.empty() ||
            !std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
            return fail(ErrorCode::badInput, "stimuli: " + name + ": expected finite numbers, at least one");
        if (values.size() > kMostStimuli / stimuli.size())
            return fail(ErrorCode::badInput,
                        "stimuli: more than " + std::to_string(kMostStimuli) + ": expected fewer");
        std::vector<Stimulus> longer;
        for (const Stimulus& head : stimuli)
            for (const double value : values) {
                longer.push_back(head);
                longer.back().push_back(value);
            }
        stimuli = std::move(longer);
    }
    return stimuli;
}

/// Returns the parameters in the function's order, independent of the order given.
core::Result<std::vector<ParameterGrid>> ordered(const std::vector<ParameterGrid>& given,
                                                 const std::vector<std::string_view>& names) {
    std::vector<ParameterGrid> inOrder;
    for (const std::string_view name : names) {
        const auto found = std::find_if(given.begin(), given.end(),
                                        [name](const ParameterGrid& p) { return p.name == name; });
        if (found == given.end())
            return fail(ErrorCode::badInput,
                        "parameters: " + std::string(name) +
                            " is missing: expected a grid for every parameter of the function");
        inOrder.push_back(*found);
    }
    for (const ParameterGrid& p : given)
        if (std::find(names.begin(), names.end(), p.name) == names.end())
            return fail(ErrorCode::badInput,
                        "parameters: " + p.name +
                            ": not a parameter of this function: expected only those it has");
    if (given.size() != names.size())
        return fail(ErrorCode::badInput, "parameters: one is given twice: expected each once");
    return inOrder;
}

/// Returns for each dimension of the function its index among the given dimensions, by name if there is more
/// than one.
core::Result<std::vector<std::size_t>> placesOf(const QuestPlusSpec& spec,
                                                const PsychometricFunction& function) {
    const std::vector<std::string_view>& names = function.stimuli;
    std::string expected;
    for (const std::string_view name : names)
        expected += (expected.empty() ? "" : ", ") + std::string(name);
    if (spec.stimuli.size() != names.size())
        return fail(ErrorCode::badInput,
                    "stimuli: expected " + std::to_string(names.size()) + " dimensions (" + expected + ")");
    if (names.size() == 1)
        return std::vector<std::size_t>{0};
    std::vector<std::size_t> places;
    for (const std::string_view name : names) {
        const auto found = std::find_if(spec.stimuli.begin(), spec.stimuli.end(),
                                        [name](const auto& dimension) { return dimension.first == name; });
        if (found == spec.stimuli.end())
            return fail(ErrorCode::badInput,
                        "stimuli: " + std::string(name) + " is missing; expected " + expected);
        places.push_back(static_cast<std::size_t>(found - spec.stimuli.begin()));
    }
    return places;
}

Stimulus arranged(const Stimulus& given, const std::vector<std::size_t>& places) {
    Stimulus out;
    for (const std::size_t place : places)
        out.push_back(given[place]);
    return out;
}

core::Result<void> checkRules(const QuestPlusSpec& spec) {
    if (spec.repeatLimit < 0)
        return fail(ErrorCode::badInput, "repeat_limit: expected at least 0");
    if (!(spec.catchEvery >= 0.0 && spec.catchEvery < 1.0))
        return fail(ErrorCode::badInput, "catch_every: expected a share from 0 to below 1");
    if (spec.stop.trials <= 0 && !(spec.stop.sd > 0.0))
        return fail(ErrorCode::badInput, "stop: expected trials or sd");
    return {};
}

/// Returns the stimulus at which a right answer (the last outcome) is most likely under the prior.
int easiestOf(const QuestPlusModel& model) {
    int easiest = 0;
    double most = -1.0;
    std::vector<double> likelihood;
    const std::vector<double>& p = model.prior.probability();
    for (std::size_t x = 0; x < model.stimuli.size(); ++x) {
        model.tables->likelihood(x, model.tables->outcomes() - 1, likelihood);
        const double right = blockedDot(p.data(), likelihood.data(), p.size());
        if (right > most) {
            most = right;
            easiest = static_cast<int>(x);
        }
    }
    return easiest;
}

core::Result<void> addFunction(QuestPlusModel& model, const QuestPlusSpec& spec) {
    const PsychometricFunction* function = psychometricFunction(spec.function);
    if (function == nullptr) {
        std::string known;
        for (const PsychometricFunction& one : psychometricFunctions())
            known += std::string(one.name) + ", ";
        return fail(ErrorCode::badInput, "function: expected one of " + known + "table");
    }
    if (spec.outcomes != 2)
        return fail(ErrorCode::badInput, "outcomes: expected 2 with this function");
    const auto places = placesOf(spec, *function);
    CHIRON_TRY(places);
    auto parameters = ordered(spec.parameters, function->parameters());
    CHIRON_TRY(parameters);
    auto prior = PosteriorGrid::make(*parameters);
    CHIRON_TRY(prior);
    if (prior->cells() > kMostEntries / model.stimuli.size())
        return fail(ErrorCode::badInput, "parameters: cells times stimuli more than " +
                                             std::to_string(kMostEntries) + ": expected fewer");
    std::vector<Stimulus> stimuli;
    for (const Stimulus& given : model.stimuli)
        stimuli.push_back(arranged(given, *places));
    auto tables = psychometricTables(*function, stimuli, *prior);
    CHIRON_TRY(tables);
    model.prior = std::move(*prior);
    model.tables = std::move(*tables);
    model.tablesAt = [function, grid = model.prior, order = *places](const Stimulus& x) {
        return psychometricTables(*function, {arranged(x, order)}, grid);
    };
    return {};
}

core::Result<void> addTable(QuestPlusModel& model, const QuestPlusSpec& spec) {
    auto prior = PosteriorGrid::make(spec.parameters);
    CHIRON_TRY(prior);
    if (!std::is_partitioned(spec.parameters.begin(), spec.parameters.end(),
                             [](const ParameterGrid& p) { return !p.nuisance; }))
        return fail(ErrorCode::badInput, "parameters: expected those that are a nuisance last, with a table");
    if (static_cast<int>(spec.table.size()) != spec.outcomes || spec.outcomes < 2)
        return fail(ErrorCode::badInput, "table: expected as many outcomes as outcomes says, at least 2");
    auto tables = generalTables(spec.table, *prior);
    CHIRON_TRY(tables);
    if ((*tables)->stimuli() != model.stimuli.size())
        return fail(ErrorCode::badInput,
                    "table: expected " + std::to_string(model.stimuli.size()) + " stimuli");
    model.prior = std::move(*prior);
    model.tables = std::move(*tables);
    return {};
}

} // namespace

void limitRepeats(QuestPlusModel& model, int limit) {
    model.repeatLimit = limit;
    if (limit <= 0)
        return;
    std::map<Stimulus, std::vector<int>> rows;
    for (std::size_t row = 0; row < model.stimuli.size(); ++row)
        rows[model.stimuli[row]].push_back(static_cast<int>(row));
    for (const Stimulus& stimulus : model.stimuli)
        model.alike.push_back(rows[stimulus]);
    if (rows.size() < model.stimuli.size())
        model.id.back() = '2';
}

core::Result<std::shared_ptr<const QuestPlusModel>> questPlusModel(const QuestPlusSpec& spec) {
    CHIRON_TRY(checkRules(spec));
    auto model = std::make_shared<QuestPlusModel>();
    model->id = "quest_plus@1";
    auto stimuli = stimuliOf(spec);
    CHIRON_TRY(stimuli);
    model->stimuli = std::move(*stimuli);
    CHIRON_TRY(spec.function == "table" ? addTable(*model, spec) : addFunction(*model, spec));
    model->stop = spec.stop;
    limitRepeats(*model, spec.repeatLimit);
    model->catchShare = spec.catchEvery;
    if (spec.catchEvery > 0.0)
        model->easiest = easiestOf(*model);
    return model;
}

} // namespace chiron::psychophysics
