// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

namespace chiron::operators {

/// Least-squares fit of slope = b (position − apex): felt slope against felt position, with one b for both
/// axes. Older observations are forgotten exponentially, because the felt position drifts, and an old
/// observation says little about where the apex now feels to be. Keeps only sums; allocates nothing.
class ApexFit {
public:
    /// `forgetting_s`: age at which an observation counts 1/e. `look_s`: time between observations.
    ApexFit(double forgetting_s, double look_s) noexcept;
    void clear() noexcept;
    void add(const core::Vec2& place, const core::Vec2& slope) noexcept;
    /// b; 1/R on a ball, about 0 on a plane or with too few observations.
    double steepening_per_m() const noexcept;
    /// Returns in `place` where the slope is zero. Returns false unless the slope rises with the position
    /// (kHill_per_m), because otherwise there is no hill.
    bool apex(core::Vec2& place) const noexcept;

    /// Assumption: anything flatter than a ball of 10 cm radius is not a hill.
    static constexpr double kHill_per_m = 10.0;

private:
    double m_keep;
    double m_n = 0.0;
    core::Vec2 m_place = core::Vec2::Zero();
    core::Vec2 m_slope = core::Vec2::Zero();
    double m_placePlace = 0.0;
    double m_placeSlope = 0.0;
};

} // namespace chiron::operators
