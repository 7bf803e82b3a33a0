// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/posterior_model.h"

#include "psychophysics/fits/beta_binomial.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::psychophysics {
namespace {

constexpr std::size_t kMost = 5;
constexpr double kImpossible = -std::numeric_limits<double>::infinity();
using Place = std::array<double, kMost>;

struct Corner {
    Place at{};
    double height = kImpossible;
};

/// The searched coordinates of a model: threshold, ln width, √η, then √lapse and √guess where they are free.
class SearchSpace {
public:
    explicit SearchSpace(const PosteriorModel& model) : m_model(model), m_size(3u + (model.free.lapse ? 1u : 0u) + (model.free.guess ? 1u : 0u)) {}
    std::size_t size() const noexcept { return m_size; }

    Place placeOf(const CurveParameters& p) const noexcept {
        Place place{p.threshold, std::log(p.width), std::sqrt(p.eta), 0.0, 0.0};
        std::size_t next = 3;
        if (m_model.free.lapse) {
            place[next++] = std::sqrt(p.lapse);
        }
        if (m_model.free.guess) {
            place[next] = std::sqrt(p.guess);
        }
        return place;
    }
    CurveParameters parametersAt(const Place& place) const noexcept {
        CurveParameters p{place[0], std::exp(place[1]), m_model.lapse, m_model.guess, m_model.overdispersion ? place[2] * place[2] : 0.0};
        std::size_t next = 3;
        if (m_model.free.lapse) {
            p.lapse = place[next] * place[next];
            ++next;
        }
        p.guess = m_model.free.equal ? p.lapse : m_model.free.guess ? place[next] * place[next] : p.guess;
        return p;
    }
    Corner weigh(const Place& place) const noexcept { return {place, m_model.logDensity(parametersAt(place))}; }

private:
    const PosteriorModel& m_model;
    std::size_t m_size;
};

class Simplex {
public:
    Simplex(const SearchSpace& space, const Place& start, double scale) : m_space(space) {
        constexpr Place kSteps{0.05, 0.25, 0.15, 0.12, 0.12};
        m_corners.push_back(space.weigh(start));
        for (std::size_t i = 0; i < space.size(); ++i) {
            Place moved = start;
            moved[i] += scale * kSteps[i];
            m_corners.push_back(space.weigh(moved));
        }
    }

    Corner climb(int steps) {
        for (int step = 0; step < steps; ++step) {
            std::sort(m_corners.begin(), m_corners.end(), [](const Corner& a, const Corner& b) { return a.height > b.height; });
            const double best = m_corners.front().height;
            if (best - m_corners.back().height < 1e-11 * (1.0 + std::abs(best))) {
                break;
            }
            advance();
        }
        return *std::max_element(m_corners.begin(), m_corners.end(), [](const Corner& a, const Corner& b) { return a.height < b.height; });
    }

private:
    Corner along(const Place& centre, double factor) const noexcept {
        Place place{};
        for (std::size_t i = 0; i < m_space.size(); ++i) {
            place[i] = centre[i] + factor * (centre[i] - m_corners.back().at[i]);
        }
        return m_space.weigh(place);
    }

    void advance() {
        const std::size_t size = m_space.size();
        Place centre{};
        for (std::size_t c = 0; c < size; ++c) {
            for (std::size_t i = 0; i < size; ++i) {
                centre[i] += m_corners[c].at[i] / static_cast<double>(size);
            }
        }
        const Corner reflected = along(centre, 1.0);
        Corner& worst = m_corners.back();
        if (reflected.height > m_corners.front().height) {
            const Corner expanded = along(centre, 2.0);
            worst = expanded.height > reflected.height ? expanded : reflected;
        } else if (reflected.height > m_corners[size - 1].height) {
            worst = reflected;
        } else {
            const Corner contracted = along(centre, reflected.height > worst.height ? 0.5 : -0.5);
            if (contracted.height > std::max(worst.height, reflected.height)) {
                worst = contracted;
            } else {
                shrink();
            }
        }
    }

    void shrink() {
        for (std::size_t c = 1; c < m_corners.size(); ++c) {
            Place place = m_corners[c].at;
            for (std::size_t i = 0; i < m_space.size(); ++i) {
                place[i] = 0.5 * (place[i] + m_corners[0].at[i]);
            }
            m_corners[c] = m_space.weigh(place);
        }
    }

    const SearchSpace& m_space;
    std::vector<Corner> m_corners;
};

} // namespace

double PosteriorModel::logDensity(const CurveParameters& at) const noexcept {
    constexpr double kMostEta = 0.999;
    if (!(at.eta >= 0.0 && at.eta < kMostEta) || (free.lapse && at.lapse > free.largestLapse) || (free.guess && at.guess > free.largestGuess)) {
        return kImpossible;
    }
    double sum = priors.logThreshold(at.threshold) + priors.logWidth(at.width) + priors.logShare(at.eta) +
                 (free.lapse ? priors.logShare(at.lapse) : 0.0) + (free.guess ? priors.logShare(at.guess) : 0.0);
    if (!std::isfinite(sum)) {
        return kImpossible;
    }
    const SigmoidUnits units = unitsOf(sigmoid);
    const double reach = 1.0 - at.lapse - at.guess, slope = units.spread / at.width;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const SigmoidValue s = sigmoidAt(sigmoid, units.middle + slope * (levels.unit[i] - at.threshold));
        sum += betaBinomialLog(levels.right[i], levels.of[i], at.guess + reach * s.rise, at.lapse + reach * s.rest, at.eta);
    }
    return sum;
}

CurveParameters posteriorMode(const PosteriorModel& model, const std::vector<CurveParameters>& starts) {
    const SearchSpace space(model);
    Corner best;
    for (const CurveParameters& start : starts) {
        const Corner found = Simplex(space, space.placeOf(start), 1.0).climb(160);
        best = found.height > best.height ? found : best;
    }
    for (const double scale : {-0.4, 0.1, -0.02}) { // again from there, so that no collapsed simplex is believed
        const Corner found = Simplex(space, best.at, scale).climb(250);
        best = found.height > best.height ? found : best;
    }
    return space.parametersAt(best.at);
}

} // namespace chiron::psychophysics
