// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/observers/simulated_observer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace chiron::psychophysics {

namespace {

int strongest(const std::vector<double>& felt) {
    return static_cast<int>(std::max_element(felt.begin(), felt.end()) - felt.begin());
}

/// Returns the perceived ranks as an answer; neighbours less than `tie` apart are equal. Of two exactly equal
/// percepts the left one is less, unless they tie.
int orderOf(const std::vector<double>& felt, double tie) {
    std::array<std::size_t, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return felt[a] < felt[b]; });
    Ranking ranks{};
    for (std::size_t i = 1; i < order.size(); ++i)
        ranks[order[i]] = static_cast<std::int8_t>(ranks[order[i - 1]] +
                                                   (felt[order[i]] - felt[order[i - 1]] < tie ? 0 : 1));
    return rankingOf(ranks);
}

/// Returns the one of three that is not in the closest pair.
int outside(const std::vector<double>& felt) {
    const std::vector<double> gaps{std::abs(felt[1] - felt[2]), std::abs(felt[0] - felt[2]),
                                   std::abs(felt[0] - felt[1])};
    return static_cast<int>(std::min_element(gaps.begin(), gaps.end()) - gaps.begin());
}

} // namespace

SimulatedObserver::SimulatedObserver(const ObserverSpec& spec, std::uint64_t seed)
    : m_spec(spec), m_sigma(sigmaOf(spec)),
      m_modulus(10.0 * std::pow(10.0, 0.2 * core::Random::stream(seed, "observer.modulus").normal())),
      m_random(core::Random::stream(seed, "observer.percepts")) {}

std::vector<double> SimulatedObserver::feltPlaces(const std::vector<double>& log10Values) {
    std::vector<double> places(log10Values.size());
    std::transform(log10Values.begin(), log10Values.end(), places.begin(),
                   [this](double v) { return felt(v); });
    return places;
}

int SimulatedObserver::answer(Task task, const std::vector<double>& log10Values) {
    const int choices = answers(task);
    if (m_random.uniform() < m_spec.lapse)
        return static_cast<int>(m_random.below(static_cast<std::uint64_t>(choices)));
    if (static_cast<int>(log10Values.size()) != placesOf(task))
        return 0;
    std::vector<double> places = feltPlaces(log10Values);
    const double bias = m_spec.bias * m_sigma;
    switch (task) {
    case Task::sameDifferent:
        return std::abs(places[0] - places[1]) + bias > std::numbers::sqrt2 * m_sigma ? 1 : 0;
    case Task::yesNo:
        return places[0] + bias > felt(0.0) ? 1 : 0;
    case Task::adjustment:
    case Task::magnitude:
        return 0;
    default:
        places[0] += bias;
        if (ranksThree(task))
            return orderOf(places, task == Task::rank3Ties ? m_spec.ties * m_sigma : 0.0);
        return task == Task::oddity ? outside(places) : strongest(places);
    }
}

double SimulatedObserver::adjust(double lowest, double highest) {
    if (m_random.uniform() < m_spec.lapse)
        return m_random.uniform(lowest, highest);
    const double error = m_sigma * (m_random.normal() - m_random.normal() + m_spec.bias);
    return std::clamp(error, lowest, highest);
}

double SimulatedObserver::magnitude(double log10Value, double exponent) {
    if (m_random.uniform() < m_spec.lapse)
        return m_modulus;
    return m_modulus * std::pow(10.0, exponent * felt(log10Value));
}

} // namespace chiron::psychophysics
