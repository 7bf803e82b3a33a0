// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/model_comparison.h"

#include "psychophysics/fits/binomial_sampler.h"
#include "psychophysics/fits/chi_square.h"
#include "psychophysics/fits/fit_summary.h"
#include "psychophysics/fits/likelihood_search.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {
namespace {

enum : std::size_t { kThreshold, kLogWidth, kLapse, kGuess, kCoordinates };

/// The parameters of all conditions in one row, with shared ones only once. Coordinates: threshold and ln
/// width on a common unit axis, lapse, guess.
class JointModel {
public:
    JointModel(std::vector<PreparedLevels> levels, const FitOptions& options, const SharedParameters& shared)
        : m_levels(std::move(levels)), m_sigmoid(options.function), m_free(freeParameters(options)),
          m_fixedLapse(options.lapse.value), m_fixedGuess(options.guess.value) {
        const std::array<bool, kCoordinates> common{shared.threshold, shared.width, shared.lapse,
                                                    shared.guess};
        const std::array<bool, kCoordinates> used{true, true, m_free.lapse, m_free.guess};
        for (std::size_t c = 0; c < m_levels.size(); ++c) {
            std::array<int, kCoordinates> at{-1, -1, -1, -1};
            for (std::size_t i = 0; i < kCoordinates; ++i) {
                if (used[i]) {
                    at[i] = common[i] && c > 0 ? m_place.front()[i] : m_size++;
                }
            }
            m_place.push_back(at);
        }
    }

    int size() const noexcept { return m_size; }
    std::size_t conditions() const noexcept { return m_levels.size(); }
    const PreparedLevels& levels(std::size_t c) const noexcept { return m_levels[c]; }
    const FreeParameters& free() const noexcept { return m_free; }
    Sigmoid sigmoid() const noexcept { return m_sigmoid; }
    int placeOf(std::size_t condition, std::size_t coordinate) const noexcept {
        return m_place[condition][coordinate];
    }
    double largest(std::size_t coordinate) const noexcept {
        return coordinate == kLapse ? m_free.largestLapse : m_free.largestGuess;
    }

    CurveParameters parameters(const std::vector<double>& row, std::size_t c) const noexcept {
        const auto& at = m_place[c];
        const auto share = [&](std::size_t i) { return row[static_cast<std::size_t>(at[i])]; };
        const double lapse = m_free.lapse ? share(kLapse) : m_fixedLapse;
        const double guess = m_free.equal ? lapse : m_free.guess ? share(kGuess) : m_fixedGuess;
        return {share(kThreshold), std::exp(share(kLogWidth)), lapse, guess, 0.0};
    }
    double logLikelihoodOf(const std::vector<double>& row) const noexcept {
        double sum = 0.0;
        for (std::size_t c = 0; c < m_levels.size(); ++c) {
            sum += logLikelihood(m_sigmoid, viewOf(m_levels[c]),
                                 toUnit(parameters(row, c), m_levels[c], m_sigmoid));
        }
        return sum;
    }

private:
    std::vector<PreparedLevels> m_levels;
    Sigmoid m_sigmoid;
    FreeParameters m_free;
    double m_fixedLapse, m_fixedGuess;
    std::vector<std::array<int, kCoordinates>> m_place;
    int m_size = 0;
};

/// Gradient and expected information of the joint log-likelihood, computed from those of the conditions by
/// the chain rule.
struct JointSums {
    std::vector<double> gradient;
    std::vector<double> information; ///< size × size
};

JointSums sumsAt(const JointModel& model, const std::vector<double>& row) {
    const auto size = static_cast<std::size_t>(model.size());
    JointSums sums{std::vector<double>(size, 0.0), std::vector<double>(size * size, 0.0)};
    const SigmoidUnits units = unitsOf(model.sigmoid());
    for (std::size_t c = 0; c < model.conditions(); ++c) {
        const CurveParameters p = model.parameters(row, c);
        const PreparedLevels& levels = model.levels(c);
        const double reach = 1.0 - p.lapse - p.guess;
        for (std::size_t i = 0; i < levels.size(); ++i) {
            const double z = std::isfinite(levels.axis[i])
                                 ? units.spread * (levels.axis[i] - p.threshold) / p.width
                                 : -1e300;
            const SigmoidValue s = sigmoidAt(model.sigmoid(), units.middle + z);
            const double psi = std::max(p.guess + reach * s.rise, 1e-300),
                         rest = std::max(p.lapse + reach * s.rest, 1e-300);
            const std::array<double, kCoordinates> d{-reach * s.slope * units.spread / p.width,
                                                     s.slope > 0.0 ? -reach * s.slope * z : 0.0,
                                                     model.free().equal ? s.rest - s.rise : -s.rise, s.rest};
            const double score =
                (levels.right[i] * rest - (levels.of[i] - levels.right[i]) * psi) / (psi * rest);
            for (std::size_t a = 0; a < kCoordinates; ++a) {
                for (std::size_t b = 0; b < kCoordinates && model.placeOf(c, a) >= 0; ++b) {
                    if (model.placeOf(c, b) >= 0) {
                        sums.information[static_cast<std::size_t>(model.placeOf(c, a)) * size +
                                         static_cast<std::size_t>(model.placeOf(c, b))] +=
                            levels.of[i] / (psi * rest) * d[a] * d[b];
                    }
                }
                if (model.placeOf(c, a) >= 0) {
                    sums.gradient[static_cast<std::size_t>(model.placeOf(c, a))] += score * d[a];
                }
            }
        }
    }
    return sums;
}

/// Solves by Gaussian elimination over the parameters that `moves` marks, with the diagonal raised by
/// `damping`. Empty if the matrix is singular.
std::vector<double> solved(const JointSums& sums, const std::vector<bool>& moves, double damping) {
    const std::size_t size = sums.gradient.size();
    std::vector<double> left = sums.information, right = sums.gradient;
    for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j) {
            left[i * size + j] = moves[i] && moves[j] ? left[i * size + j] : 0.0;
        }
        left[i * size + i] = moves[i] ? left[i * size + i] * (1.0 + damping) : 1.0;
        right[i] = moves[i] ? right[i] : 0.0;
    }
    for (std::size_t pivot = 0; pivot < size; ++pivot) {
        if (!(left[pivot * size + pivot] > 0.0)) {
            return {};
        }
        for (std::size_t i = pivot + 1; i < size; ++i) {
            const double factor = left[i * size + pivot] / left[pivot * size + pivot];
            for (std::size_t j = pivot; j < size; ++j) {
                left[i * size + j] -= factor * left[pivot * size + j];
            }
            right[i] -= factor * right[pivot];
        }
    }
    for (std::size_t i = size; i-- > 0;) {
        for (std::size_t j = i + 1; j < size; ++j) {
            right[i] -= left[i * size + j] * right[j];
        }
        right[i] /= left[i * size + i];
    }
    return right;
}

/// Climbs over all conditions at once. Moves `row` to the maximum and returns the log-likelihood there.
double climbJoint(const JointModel& model, std::vector<double>& row) {
    double height = model.logLikelihoodOf(row), damping = 1e-3;
    std::vector<bool> isShare(row.size(), false);
    std::vector<double> most(row.size(), 0.0);
    for (std::size_t c = 0; c < model.conditions(); ++c) {
        for (const std::size_t i : {std::size_t{kLapse}, std::size_t{kGuess}}) {
            if (const int at = model.placeOf(c, i); at >= 0) {
                isShare[static_cast<std::size_t>(at)] = true;
                most[static_cast<std::size_t>(at)] = model.largest(i);
            }
        }
    }
    for (int step = 0; step < 300; ++step) {
        const JointSums sums = sumsAt(model, row);
        std::vector<bool> moves(row.size(), true);
        for (std::size_t i = 0; i < row.size(); ++i) {
            moves[i] = !isShare[i] || !((row[i] <= 0.0 && sums.gradient[i] <= 0.0) ||
                                        (row[i] >= most[i] && sums.gradient[i] >= 0.0));
        }
        const std::vector<double> move = solved(sums, moves, damping);
        double decrement = 0.0;
        std::vector<double> tried = row;
        for (std::size_t i = 0; i < move.size(); ++i) {
            decrement += move[i] * (moves[i] ? sums.gradient[i] : 0.0);
            tried[i] = isShare[i] ? std::clamp(row[i] + move[i], 0.0, most[i]) : row[i] + move[i];
        }
        if (move.empty() || decrement < 1e-11) {
            break;
        }
        const double there = model.logLikelihoodOf(tried);
        if (there >= height) {
            row = tried;
            height = there;
            damping *= 0.2;
        } else if ((damping = std::max(10.0 * damping, 1e-3)) > 1e9) {
            break;
        }
    }
    return height;
}

/// Returns a start from separate fits of the conditions; shared parameters start at the mean.
std::vector<double> jointStart(const JointModel& model, const FitOptions& options) {
    std::vector<double> row(static_cast<std::size_t>(model.size()), 0.0), count(row.size(), 0.0);
    for (std::size_t c = 0; c < model.conditions(); ++c) {
        const PreparedLevels& levels = model.levels(c);
        const SearchResult alone = searchMaximum(options.function, viewOf(levels), model.free(),
                                                 options.lapse.value, options.guess.value);
        CurveParameters p = fromUnit(alone.curve, levels, options.function);
        p.width = std::clamp(p.width, 0.3 * levels.spacing, 3.0 * levels.range);
        p.threshold =
            std::clamp(p.threshold, levels.centre - 0.6 * levels.range, levels.centre + 0.6 * levels.range);
        const std::array<double, kCoordinates> values{p.threshold, std::log(p.width), std::max(p.lapse, 0.01),
                                                      std::max(p.guess, 0.01)};
        for (std::size_t i = 0; i < kCoordinates; ++i) {
            if (const int at = model.placeOf(c, i); at >= 0) {
                row[static_cast<std::size_t>(at)] += values[i];
                count[static_cast<std::size_t>(at)] += 1.0;
            }
        }
    }
    for (std::size_t i = 0; i < row.size(); ++i) {
        row[i] /= count[i];
    }
    return row;
}

} // namespace

ConditionsFit fitConditions(const std::vector<PsychometricData>& conditions, const FitOptions& given,
                            const SharedParameters& shared) {
    const FitOptions options = settled(given);
    ConditionsFit fit;
    if (std::string problem = optionsProblem(options); !problem.empty()) {
        fit.warnings.push_back(std::move(problem));
    }
    std::vector<PreparedLevels> levels;
    double coefficients = 0.0;
    for (std::size_t c = 0; c < conditions.size(); ++c) {
        levels.push_back(prepareLevels(conditions[c], options.scale.value_or(ownScale(options.function))));
        coefficients += levels.back().logCoefficients;
        const bool mixed = levels.back().totalRight > 0.0 && levels.back().totalRight < levels.back().total;
        if (!levels.back().usable() || !mixed) {
            fit.warnings.push_back("condition_not_usable: condition " + std::to_string(c + 1) +
                                   " has fewer than two intensities, or only right or only wrong answers");
        }
    }
    if (conditions.empty() || !fit.warnings.empty()) {
        return fit;
    }
    const JointModel model(std::move(levels), options, shared);
    std::vector<double> row = jointStart(model, options);
    fit.logLikelihood = climbJoint(model, row) + coefficients;
    for (std::size_t c = 0; c < model.conditions(); ++c) {
        fit.conditions.push_back(model.parameters(row, c));
    }
    fit.freeParameters = model.size();
    fit.aic = 2.0 * fit.freeParameters - 2.0 * fit.logLikelihood;
    fit.fitted = true;
    return fit;
}

namespace {

/// Returns ψ at an intensity in given units.
double proportionOf(const CurveParameters& p, double x, const FitOptions& options) {
    const SigmoidUnits units = unitsOf(options.function);
    const double axis = toScale(x, *options.scale);
    const double z = std::isfinite(axis) ? units.spread * (axis - p.threshold) / p.width : -1e300;
    return p.guess + (1.0 - p.lapse - p.guess) * sigmoidAt(options.function, units.middle + z).rise;
}

double likelihoodRatio(const ConditionsFit& smaller, const ConditionsFit& larger) noexcept {
    return smaller.fitted && larger.fitted
               ? std::max(0.0, 2.0 * (larger.logLikelihood - smaller.logLikelihood))
               : kNotKnown;
}

/// Computes the Monte Carlo p: the share of data sets drawn from the smaller model whose likelihood ratio is
/// at least as large.
void simulate(ModelComparison& comparison, const std::vector<PsychometricData>& conditions,
              const FitOptions& options, const SharedParameters& both, const SharedParameters& shared) {
    struct Row {
        std::size_t condition, row;
        BinomialSampler sampler;
    };
    std::vector<Row> rows;
    for (std::size_t c = 0; c < conditions.size(); ++c) {
        for (std::size_t i = 0; i < conditions[c].x.size(); ++i) {
            if (isUsableRow(conditions[c].x[i], conditions[c].k[i], conditions[c].n[i])) {
                const double share = std::clamp(
                    proportionOf(comparison.smaller.conditions[c], conditions[c].x[i], options), 0.0, 1.0);
                rows.push_back({c, i, BinomialSampler(conditions[c].n[i], share)});
            }
        }
    }
    core::Random random = core::Random::stream(options.seed, "comparison of models");
    std::vector<PsychometricData> drawn = conditions;
    int asLarge = 0;
    for (int i = 0; i < options.monteCarlo; ++i) {
        for (const Row& row : rows) {
            drawn[row.condition].k[row.row] = row.sampler.draw(random);
        }
        const double ratio =
            likelihoodRatio(fitConditions(drawn, options, both), fitConditions(drawn, options, shared));
        comparison.simulated += std::isfinite(ratio) ? 1 : 0;
        asLarge += ratio >= comparison.likelihoodRatio - 1e-9 ? 1 : 0;
    }
    comparison.pValue = (1.0 + asLarge) / (1.0 + comparison.simulated);
}

} // namespace

ModelComparison compareConditions(const std::vector<PsychometricData>& conditions, const FitOptions& given,
                                  const SharedParameters& shared, const SharedParameters& tested) {
    FitOptions options = settled(given);
    options.scale = options.scale.value_or(ownScale(options.function));
    const SharedParameters both{shared.threshold || tested.threshold, shared.width || tested.width,
                                shared.lapse || tested.lapse, shared.guess || tested.guess};
    ModelComparison comparison{fitConditions(conditions, options, both),
                               fitConditions(conditions, options, shared)};
    if (comparison.smaller.fitted && comparison.larger.fitted) {
        comparison.likelihoodRatio = likelihoodRatio(comparison.smaller, comparison.larger);
        comparison.freedom = comparison.larger.freeParameters - comparison.smaller.freeParameters;
        comparison.pValue = comparison.chiSquareP =
            chiSquareTail(comparison.likelihoodRatio, comparison.freedom);
        comparison.aicDifference = comparison.smaller.aic - comparison.larger.aic;
        if (options.monteCarlo > 0) {
            simulate(comparison, conditions, options, both, shared);
        }
    }
    return comparison;
}

} // namespace chiron::psychophysics
