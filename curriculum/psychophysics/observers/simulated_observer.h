// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "psychophysics/observers/observer_spec.h"
#include "psychophysics/study/arrangement.h"

#include <cstdint>
#include <vector>

namespace chiron::psychophysics {

/// A participant that follows Thurstone's model: each object is perceived with independent normal noise of sd
/// σ in log10 units, and the task's rule is applied to the percepts. The observer is given the values at the
/// positions (in a study with rendering: its own estimates of them from measured force), never the right
/// answer. Deterministic for a given seed and sequence of calls.
class SimulatedObserver {
public:
    SimulatedObserver(const ObserverSpec& spec, std::uint64_t seed);

    /// Returns the answer as `answers(task)` counts it. `log10Values` holds, for each position, log10 of its
    /// value relative to the reference. rank3: the perceived order; rank3_ties: the same, but neighbours less
    /// than `ties` σ apart are equal; 2afc, 3afc: the position perceived as most; oddity: the one outside the
    /// closest pair (differencing); same_different: different if two percepts lie more than √2 σ apart;
    /// yes_no: yes if it is perceived as more than the remembered reference, which has the same noise;
    /// adjustment, magnitude: 0.
    int answer(Task task, const std::vector<double>& log10Values);

    /// Returns the setting of the comparison, log10 relative to the reference, within lowest..highest. Both
    /// are perceived with noise. A lapse sets it anywhere.
    double adjust(double lowest, double highest);

    /// Returns the number given for a value: modulus · (value/reference)^exponent as perceived. Each
    /// participant has a modulus of its own (about 10).
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
