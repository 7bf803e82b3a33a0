// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cues/laparoscopy_cues.h"

#include <array>
#include <cstddef>

namespace chiron::operators {

/// Remembers how heavy each object felt: means over all observations of it, N. It contains no true values.
class WeightMemory {
public:
    static constexpr std::size_t kMost = core::LaparoscopyCues::kMaxBodies;
    void begin(std::size_t objects) noexcept;
    void feel(std::size_t object, double weight_N) noexcept; ///< once per observation
    void weighed(std::size_t object) noexcept { ++m_times[object]; }
    int times(std::size_t object) const noexcept { return m_times[object]; }
    double weight_N(std::size_t object) const noexcept {
        return m_looks[object] > 0.0 ? m_sum_N[object] / m_looks[object] : 0.0;
    }
    /// The next object, in the screen's order, that has been weighed fewer than `times` times; objects() when
    /// there is none.
    std::size_t next(int times) const noexcept;
    std::size_t objects() const noexcept { return m_objects; }
    std::size_t heaviest() const noexcept;
    std::size_t second() const noexcept; ///< heaviest after heaviest(); objects() when there is only one
    /// Says whether the two heaviest differ by less than this share of the heavier one.
    bool close(double share) const noexcept;

private:
    std::size_t m_objects = 0;
    std::array<double, kMost> m_sum_N{};
    std::array<double, kMost> m_looks{};
    std::array<int, kMost> m_times{};
};

} // namespace chiron::operators
