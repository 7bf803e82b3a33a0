// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/posterior_mode.h"

#include <algorithm>
#include <array>
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
    explicit SearchSpace(const PosteriorModel& model)
        : m_model(model), m_size(3u + (model.free.lapse ? 1u : 0u) + (model.free.guess ? 1u : 0u)) {}
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
        CurveParameters p{place[0], std::exp(place[1]), m_model.lapse, m_model.guess,
                          m_model.overdispersion ? place[2] * place[2] : 0.0};
        std::size_t next = 3;
        if (m_model.free.lapse) {
            p.lapse = place[next] * place[next];
            ++next;
        }
        p.guess = m_model.free.equal ? p.lapse : m_model.free.guess ? place[next] * place[next] : p.guess;
        return p;
    }
    Corner weigh(const Place& place) const noexcept {
        return {place, m_model.logDensity(parametersAt(place))};
    }

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
            moved[i] += scale * (i == 0 ? std::min(kSteps[0], 0.3 * std::exp(start[1])) : kSteps[i]);
            m_corners.push_back(space.weigh(moved));
        }
    }

    Corner climb(int steps) {
        for (int step = 0; step < steps; ++step) {
            std::sort(m_corners.begin(), m_corners.end(),
                      [](const Corner& a, const Corner& b) { return a.height > b.height; });
            const double best = m_corners.front().height;
            if (best - m_corners.back().height < 1e-11 * (1.0 + std::abs(best))) {
                break;
            }
            advance();
        }
        return *std::max_element(m_corners.begin(), m_corners.end(),
                                 [](const Corner& a, const Corner& b) { return a.height < b.height; });
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

/// Candidate starting curves with their log densities.
class Candidates {
public:
    explicit Candidates(const PosteriorModel& model) : m_model(model) {}

    void add(CurveParameters at) {
        at.eta = m_model.overdispersion ? at.eta : 0.0;
        at.lapse = m_model.free.lapse ? at.lapse : m_model.lapse;
        at.guess = m_model.free.equal ? at.lapse : m_model.free.guess ? at.guess : m_model.guess;
        if (const double height = m_model.logDensity(at); std::isfinite(height)) {
            m_all.emplace_back(height, at);
        }
    }

    /// Adds a curve as it is, with each share at 0, and with all shares at 0.
    void addWithEdges(const CurveParameters& at) {
        constexpr double kSmall = 1e-6; // at 0 itself some answers may be impossible
        add(at);
        CurveParameters edge = at, bare = at;
        edge.eta = bare.eta = 0.0;
        add(edge);
        if (m_model.free.lapse) {
            edge = at;
            edge.lapse = bare.lapse = kSmall;
            add(edge);
        }
        if (m_model.free.guess) {
            edge = at;
            edge.guess = bare.guess = kSmall;
            add(edge);
        }
        add(bare);
    }

    /// Returns the candidates with the highest log density that are not close to a better one.
    std::vector<CurveParameters> best(std::size_t most) {
        std::stable_sort(m_all.begin(), m_all.end(),
                         [](const auto& a, const auto& b) { return a.first > b.first; });
        std::vector<CurveParameters> chosen;
        for (const auto& [height, at] : m_all) {
            if (std::none_of(chosen.begin(), chosen.end(),
                             [&at = at](const CurveParameters& other) { return alike(at, other); })) {
                chosen.push_back(at);
            }
            if (chosen.size() == most) {
                break;
            }
        }
        return chosen;
    }

private:
    static bool alike(const CurveParameters& a, const CurveParameters& b) noexcept {
        const double width = std::min(a.width, b.width);
        return std::abs(a.threshold - b.threshold) < 0.4 * width &&
               std::abs(std::log(a.width / b.width)) < 0.5 && (a.eta > 0.0) == (b.eta > 0.0) &&
               std::abs(std::sqrt(a.lapse) - std::sqrt(b.lapse)) < 0.15 &&
               std::abs(std::sqrt(a.guess) - std::sqrt(b.guess)) < 0.15;
    }

    const PosteriorModel& m_model;
    std::vector<std::pair<double, CurveParameters>> m_all;
};

/// Adds the best cell for each width.
void addCells(Candidates& candidates, const DensityGrid& grid) {
    const std::size_t widths = grid.axes().axis[PosteriorAxes::logWidth].size();
    std::vector<std::size_t> best(widths, 0);
    std::vector<double> height(widths, kImpossible);
    for (std::size_t cell = 0; cell < grid.logs().size(); ++cell) {
        const std::size_t width = grid.nodeOf(cell, PosteriorAxes::logWidth);
        if (grid.logs()[cell] > height[width]) {
            height[width] = grid.logs()[cell];
            best[width] = cell;
        }
    }
    for (std::size_t width = 0; width < widths; ++width) {
        if (std::isfinite(height[width])) {
            candidates.addWithEdges(grid.parametersAt(best[width]));
        }
    }
}

/// Adds thresholds at and between levels, at most sixty of them, with several widths and with few and
/// many lapses and guesses.
void addLevels(Candidates& candidates, const PosteriorModel& model) {
    constexpr std::size_t kMostPlaces = 60, kWidths = 6;
    constexpr double kFew = 0.03, kMany = 0.15;
    const std::vector<double>& unit = model.levels.unit;
    const std::size_t places = 2 * unit.size() - 1, every = (places + kMostPlaces - 1) / kMostPlaces;
    const double low = std::log(1.3 * model.priors.lowestWidth()),
                 high = std::log(0.8 * model.priors.largestWidth());
    for (std::size_t place = 0; place < places; place += every) {
        const double threshold = 0.5 * (unit[place / 2] + unit[(place + 1) / 2]);
        for (std::size_t w = 0; w < kWidths; ++w) {
            const double width = std::exp(low + (high - low) * static_cast<double>(w) / (kWidths - 1.0));
            for (const auto& [lapse, guess] : {std::pair{kFew, kFew}, {kMany, kFew}, {kFew, kMany}}) {
                if (guess == kFew || model.free.guess) {
                    candidates.add({threshold, width, lapse, guess, 0.1});
                }
            }
        }
    }
}

} // namespace

std::vector<CurveParameters> modeStarts(const PosteriorModel& model, const DensityGrid& whole) {
    constexpr std::size_t kPlaces = 24, kStarts = 32;
    Candidates atLevels(model), candidates(model);
    addLevels(atLevels, model);
    for (const CurveParameters& at : atLevels.best(kPlaces)) {
        candidates.addWithEdges(at);
    }
    addCells(candidates, whole);
    return candidates.best(kStarts);
}

CurveParameters posteriorMode(const PosteriorModel& model, const std::vector<CurveParameters>& starts) {
    const SearchSpace space(model);
    std::vector<Corner> tops;
    for (const CurveParameters& start : starts) {
        tops.push_back(Simplex(space, space.placeOf(start), 1.0).climb(50));
    }
    Corner best;
    for (const auto& [keep, steps] :
         {std::pair<std::size_t, int>{8, 120}, {3, 200}}) { // fewer and longer climbs
        std::stable_sort(tops.begin(), tops.end(),
                         [](const Corner& a, const Corner& b) { return a.height > b.height; });
        tops.resize(std::min(keep, tops.size()));
        for (Corner& top : tops) {
            top = Simplex(space, top.at, -0.5).climb(steps);
            best = top.height > best.height ? top : best;
        }
    }
    // Climb again from the result, so that a collapsed simplex is not mistaken for the mode.
    for (const double scale : {-0.4, 0.1, -0.02}) {
        const Corner found = Simplex(space, best.at, scale).climb(250);
        best = found.height > best.height ? found : best;
    }
    return space.parametersAt(best.at);
}

} // namespace chiron::psychophysics
