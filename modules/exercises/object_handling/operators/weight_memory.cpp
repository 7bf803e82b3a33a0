// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/object_handling/operators/weight_memory.h"

#include <algorithm>

namespace chiron::operators {

void WeightMemory::begin(std::size_t objects) noexcept {
    m_objects = std::min(objects, kMost);
    m_sum_N.fill(0.0);
    m_looks.fill(0.0);
    m_times.fill(0);
}

void WeightMemory::feel(std::size_t object, double weight_N) noexcept {
    m_sum_N[object] += weight_N;
    m_looks[object] += 1.0;
}

std::size_t WeightMemory::next(int times) const noexcept {
    for (std::size_t i = 0; i < m_objects; ++i)
        if (m_times[i] < times)
            return i;
    return m_objects;
}

std::size_t WeightMemory::heaviest() const noexcept {
    std::size_t best = 0;
    for (std::size_t i = 1; i < m_objects; ++i)
        if (weight_N(i) > weight_N(best))
            best = i;
    return best;
}

std::size_t WeightMemory::second() const noexcept {
    const std::size_t first = heaviest();
    std::size_t best = m_objects;
    for (std::size_t i = 0; i < m_objects; ++i)
        if (i != first && (best == m_objects || weight_N(i) > weight_N(best)))
            best = i;
    return best;
}

bool WeightMemory::close(double share) const noexcept {
    const std::size_t other = second();
    return other < m_objects && weight_N(heaviest()) - weight_N(other) < share * weight_N(heaviest());
}

} // namespace chiron::operators
