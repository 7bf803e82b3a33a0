// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/procedures/rank3_quest_plus.h"

#include "psychophysics/observers/thurstone.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {

using core::ErrorCode;
using core::fail;

namespace {

using Table = std::vector<std::vector<std::vector<double>>>;

core::Result<void> check(const Rank3Spec& spec) {
    const auto bad = [](const char* what) { return fail(ErrorCode::badInput, what); };
    if (spec.differences.empty() ||
        !std::all_of(spec.differences.begin(), spec.differences.end(), [](double d) { return std::isfinite(d) && d > 0.0; }))
        return bad("differences: expected positive numbers (log10 of a ratio), at least one");
    if (!std::all_of(spec.log10Sigma.begin(), spec.log10Sigma.end(), [](double s) { return std::abs(s) < 20.0; }))
        return bad("log10_sigma: expected finite numbers within 20 of 0");
    if (!std::all_of(spec.lapse.begin(), spec.lapse.end(), [](double l) { return l >= 0.0 && l < 1.0; }))
        return bad("lapse_rates: expected shares from 0 to below 1");
    if (spec.stop.trials <= 0 && !(spec.stop.sd > 0.0))
        return bad("stop: expected trials or sd");
    if (spec.allowTies)
        return bad("allow_ties: ties are not modelled yet: expected false");
    if (spec.repeatLimit < 0)
        return bad("repeat_limit: expected at least 0");
    return {};
}

/// The probabilities of one difference for every cell: log10 σ outermost, then λ.
void fill(Table& table, std::size_t row, double difference, const Rank3Spec& spec) {
    std::size_t cell = 0;
    for (const double log10Sigma : spec.log10Sigma) {
        const auto pure = rankProbabilities(difference / std::pow(10.0, log10Sigma));
        for (const double lapse : spec.lapse) {
            for (std::size_t r = 0; r < pure.size(); ++r)
                table[r][row][cell] = (1.0 - lapse) * pure[r] + lapse / 6.0;
            ++cell;
        }
    }
}

core::Result<std::shared_ptr<const OutcomeTables>> tablesOf(const std::vector<double>& differences, const Rank3Spec& spec,
                                                           const PosteriorGrid& grid) {
    Table table(6, std::vector<std::vector<double>>(differences.size(), std::vector<double>(grid.cells())));
    for (std::size_t row = 0; row < differences.size(); ++row)
        fill(table, row, differences[row], spec);
    return generalTables(table, grid);
}

/// From a tenth of the smallest difference to three times the largest.
std::vector<double> defaultLog10Sigma(const std::vector<double>& differences) {
    const auto [least, most] = std::minmax_element(differences.begin(), differences.end());
    const double low = std::log10(*least) - 1.0;
    const double count = std::ceil((std::log10(*most) + std::log10(3.0) - low) / 0.05);
    std::vector<double> grid;
    for (double i = 0.0; i <= count; i += 1.0)
        grid.push_back(low + 0.05 * i);
    return grid;
}

} // namespace

core::Result<std::shared_ptr<const QuestPlusModel>> rank3Model(const Rank3Spec& given) {
    if (auto good = check(given); !good)
        return tl::unexpected(good.error());
    Rank3Spec spec = given;
    if (spec.log10Sigma.empty())
        spec.log10Sigma = defaultLog10Sigma(spec.differences);
    auto prior = PosteriorGrid::make({{"log10_sigma", spec.log10Sigma, {}, false}, {"lapse", spec.lapse, {}, false}});
    if (!prior)
        return tl::unexpected(prior.error());
    auto tables = tablesOf(spec.differences, spec, *prior);
    if (!tables)
        return tl::unexpected(tables.error());
    auto model = std::make_shared<QuestPlusModel>();
    model->id = "rank3_quest_plus@1";
    for (const double difference : spec.differences)
        model->stimuli.push_back({difference});
    model->prior = std::move(*prior);
    model->tables = std::move(*tables);
    model->tablesAt = [spec, grid = model->prior](const Stimulus& x) { return tablesOf(x, spec, grid); };
    model->stop = spec.stop;
    model->repeatLimit = spec.repeatLimit;
    return model;
}

} // namespace chiron::psychophysics
