// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

namespace chiron::operators {

/// Least squares of slope = b (place − apex), felt slope against felt place, both axes with one b, older
/// looks forgotten exponentially: felt place drifts, so that what was felt long ago says little about where
/// the apex feels to be now. By sums, no allocation.
class ApexFit {
public:
    /// `forgetting_s`: looks so old count 1/e.
    ApexFit(double forgetting_s, double look_s) noexcept;
    void clear() noexcept;
    void add(const core::Vec2& place, const core::Vec2& slope) noexcept;
    double steepening_per_m() const noexcept; ///< b; 1/R on a ball, about 0 on a plane or with too few looks
    /// Where the slope is zero; false unless it rises with the place (kHill_per_m): then there is no hill.
    bool apex(core::Vec2& place) const noexcept;

    static constexpr double kHill_per_m =
        10.0; ///< flatter than a ball of 10 cm radius is no hill: assumption

private:
    double m_keep;
    double m_n = 0.0;
    core::Vec2 m_place = core::Vec2::Zero();
    core::Vec2 m_slope = core::Vec2::Zero();
    double m_placePlace = 0.0;
    double m_placeSlope = 0.0;
};

} // namespace chiron::operators
