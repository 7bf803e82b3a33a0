// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/procedures/rank3_quest_plus.h"

#include "psychophysics/observers/thurstone.h"
#include "psychophysics/observers/tied_orders.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {

using core::ErrorCode;
using core::fail;

namespace {

constexpr double kMostTie = 20.0; ///< σ
/// Differences times cells; every outcome has a table of this size.
constexpr std::size_t kMostTableEntries = 4'000'000;

using Table = std::vector<std::vector<std::vector<double>>>;

core::Result<void> checkRank3Spec(const Rank3Spec& spec) {
    const auto bad = [](const char* what) { return fail(ErrorCode::badInput, what); };
    if (spec.differences.empty() || !std::all_of(spec.differences.begin(), spec.differences.end(),
                                                 [](double d) { return std::isfinite(d) && d > 0.0; }))
        return bad("differences: expected positive numbers (log10 of a ratio), at least one");
    if (!std::all_of(spec.log10Sigma.begin(), spec.log10Sigma.end(),
                     [](double s) { return std::abs(s) < 20.0; }))
        return bad("log10_sigma: expected finite numbers within 20 of 0");
    if (spec.lapse.empty() ||
        !std::all_of(spec.lapse.begin(), spec.lapse.end(), [](double l) { return l >= 0.0 && l < 1.0; }))
        return bad("lapse_rates: expected shares from 0 to below 1, at least one");
    if (spec.stop.trials <= 0 && !(spec.stop.sd > 0.0))
        return bad("stop: expected trials or sd");
    if (spec.allowTies &&
        (spec.tieThresholds.empty() || !std::all_of(spec.tieThresholds.begin(), spec.tieThresholds.end(),
                                                    [](double tie) { return tie > 0.0 && tie <= kMostTie; })))
        return bad("tie_thresholds: expected positive numbers (in sigma) up to 20, at least one");
    if (spec.repeatLimit < 0)
        return bad("repeat_limit: expected at least 0");
    return {};
}

/// Probabilities of the outcomes at d = D/σ, without lapses: of the six orders, or of the 13 rankings for
/// each tie threshold.
class Observers {
public:
    explicit Observers(const Rank3Spec& spec) {
        if (spec.allowTies)
            for (const double tie : spec.tieThresholds)
                m_ties.emplace_back(tie);
    }
    std::size_t count() const { return std::max<std::size_t>(1, m_ties.size()); }
    int outcomes() const { return m_ties.empty() ? kStrictRankings : kRankings; }
    std::vector<double> at(std::size_t which, double d) const {
        const auto copied = [](const auto& p) { return std::vector<double>(p.begin(), p.end()); };
        return m_ties.empty() ? copied(rankProbabilities(d)) : copied(m_ties[which].at(d));
    }

private:
    std::vector<TiedOrderTable> m_ties;
};

/// Fills in the probabilities of one difference for every cell: log10 σ outermost, then the tie threshold if
/// there is one, then λ.
void fill(Table& table, std::size_t row, double difference, const Rank3Spec& spec,
          const Observers& observers) {
    std::size_t cell = 0;
    for (const double log10Sigma : spec.log10Sigma)
        for (std::size_t which = 0; which < observers.count(); ++which) {
            const std::vector<double> pure = observers.at(which, difference / std::pow(10.0, log10Sigma));
            for (const double lapse : spec.lapse) {
                for (std::size_t r = 0; r < pure.size(); ++r)
                    table[r][row][cell] = (1.0 - lapse) * pure[r] + lapse / static_cast<double>(pure.size());
                ++cell;
            }
        }
}

core::Result<std::shared_ptr<const OutcomeTables>> tablesOf(const std::vector<double>& differences,
                                                            const Rank3Spec& spec, const Observers& observers,
                                                            const PosteriorGrid& grid) {
    Table table(static_cast<std::size_t>(observers.outcomes()),
                std::vector<std::vector<double>>(differences.size(), std::vector<double>(grid.cells())));
    for (std::size_t row = 0; row < differences.size(); ++row)
        fill(table, row, differences[row], spec, observers);
    return generalTables(table, grid);
}

/// Returns a grid from a tenth of the smallest difference to three times the largest.
std::vector<double> defaultLog10Sigma(const std::vector<double>& differences) {
    const auto [least, most] = std::minmax_element(differences.begin(), differences.end());
    const double low = std::log10(*least) - 1.0;
    const double count = std::ceil((std::log10(*most) + std::log10(3.0) - low) / 0.05);
    std::vector<double> grid;
    for (double i = 0.0; i <= count; i += 1.0)
        grid.push_back(low + 0.05 * i);
    return grid;
}

/// Checks that all tables together stay within what memory and time allow. The grid of log10 σ must be filled
/// in already.
core::Result<void> checkSize(const Rank3Spec& spec) {
    std::size_t most = kMostTableEntries / spec.differences.size();
    for (const std::size_t factor :
         {spec.log10Sigma.size(), spec.lapse.size(),
          spec.allowTies ? 2 * spec.tieThresholds.size() : 1}) // 13 outcomes, not six
        most /= factor;
    if (most == 0)
        return fail(ErrorCode::badInput,
                    "differences: times log10_sigma, lapse_rates and tie_thresholds more than " +
                        std::to_string(kMostTableEntries) + ": expected fewer");
    return {};
}

/// A checked specification with its grid of log10 σ, and the prior.
struct Checked {
    Rank3Spec spec;
    PosteriorGrid prior;
};

core::Result<Checked> checked(Rank3Spec spec) {
    CHIRON_TRY(checkRank3Spec(spec));
    if (spec.log10Sigma.empty())
        spec.log10Sigma = defaultLog10Sigma(spec.differences);
    CHIRON_TRY(checkSize(spec));
    std::vector<ParameterGrid> axes{{"log10_sigma", spec.log10Sigma, {}, false},
                                    {"lapse", spec.lapse, {}, false}};
    if (spec.allowTies)
        axes.insert(axes.begin() + 1, {"tie_threshold", spec.tieThresholds, {}, false});
    auto prior = PosteriorGrid::make(axes);
    CHIRON_TRY(prior);
    return Checked{std::move(spec), *std::move(prior)};
}

} // namespace

core::Result<void> checkRank3(const Rank3Spec& spec) {
    const auto good = checked(spec);
    CHIRON_TRY(good);
    return {};
}

core::Result<std::shared_ptr<const QuestPlusModel>> rank3Model(const Rank3Spec& given) {
    auto good = checked(given);
    CHIRON_TRY(good);
    const Rank3Spec& spec = good->spec;
    const Observers observers(spec);
    auto tables = tablesOf(spec.differences, spec, observers, good->prior);
    CHIRON_TRY(tables);
    auto model = std::make_shared<QuestPlusModel>();
    model->id = spec.allowTies ? "rank3_quest_plus_ties@1" : "rank3_quest_plus@1";
    for (const double difference : spec.differences)
        model->stimuli.push_back({difference});
    model->prior = std::move(good->prior);
    model->tables = std::move(*tables);
    model->tablesAt = [spec, observers, grid = model->prior](const Stimulus& x) {
        return tablesOf(x, spec, observers, grid);
    };
    model->stop = spec.stop;
    limitRepeats(*model, spec.repeatLimit);
    return model;
}

} // namespace chiron::psychophysics
