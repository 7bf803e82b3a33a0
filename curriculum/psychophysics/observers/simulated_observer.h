// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "psychophysics/observers/observer_spec.h"
#include "psychophysics/study/arrangement.h"

#include <cstdint>
#include <vector>

namespace chiron::psychophysics {

/// A participant by Thurstone's model: what lies at a place is felt with independent normal noise of sd σ in log10 units, and the task's rule
/// is applied to what is felt. It is given the values of the places (a study through the rendering: its own estimates of them from
/// measured force), never which answer is right. Deterministic by seed and calls.
class SimulatedObserver {
public:
    SimulatedObserver(const ObserverSpec& spec, std::uint64_t seed);

    /// `log10Values`: of each place, log10 of its value over the reference. The answer as `answers(task)` counts it:
    /// rank3: the order felt; rank3_ties: the same, neighbours less than `ties` σ apart equal; 2afc, 3afc: the place felt most; oddity: the one outside the closest pair (differencing); same_different:
    /// different where two percepts lie more than √2 σ apart; yes_no: yes where it is felt as more than the remembered
    /// reference, which has the same noise; adjustment, magnitude: 0.
    int answer(Task task, const std::vector<double>& log10Values);

    /// Where the comparison is set, log10 over the reference, within lowest..highest: both are felt with noise. A lapse sets it anywhere.
    double adjust(double lowest, double highest);

    /// The number said of a value: modulus · (value/reference)^exponent as felt; each participant has a modulus of its own (about 10).
    double magnitude(double log10Value, double exponent = 1.0);

    double sigma() const noexcept { return m_sigma; }

private:
    double felt(double log10Value) { return log10Value + m_sigma * m_random.normal(); }
    std::vector<double> feltPlaces(const std::vector<double>& log10Values);

    ObserverSpec m_spec;
    double m_sigma;
    double m_modulus;
    core::Random m_random;
};

} // namespace chiron::psychophysics
