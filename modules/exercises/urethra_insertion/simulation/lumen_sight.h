// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"

#include <array>
#include <cstddef>
#include <vector>

namespace chiron::simulation {

/// How far ahead the lumen's middle can be seen from the tip. The rule, one for scripted operators and for the guidance drawn in
/// the picture:
///   the centre-line ahead is taken at points 2.5 mm apart, from 2.5 to 60 mm before the tip; each carries the lumen's
///   middle, which near the tip lies with the endoscope (centre-line + W e, models.md §1.1), and its opened radius;
///   a point can be seen when the straight line to it from the tip passes every nearer point within that one's radius, and when
///   it lies in the field of view. The farthest such point is the answer; none: the picture shows wall alone.
/// Before the entrance there is no wall; past the neck the lumen is the bladder's sphere. Made at set-up; look() is the
/// tick's: no allocation, about 0.2 µs.
class LumenSight {
public:
    static constexpr double kStep_m = 0.0025;
    static constexpr std::size_t kAhead = 24;

    explicit LumenSight(const UrethraInsertionParameters& parameters);

    struct View {
        bool open = false;
        core::Vec3 p_A = core::Vec3::Zero(); ///< the farthest visible middle of the lumen
    };
    /// `axis_A`: unit, the way the endoscope looks; `foot` is p_A's.
    View look(const core::Vec3& p_A, const core::Vec3& axis_A, const CentrelineFoot& foot) const noexcept;

private:
    struct Station {
        double s_m = 0.0;
        double radius_m = 0.0; ///< at rest; past the neck the bladder's
        core::Vec3 p_A = core::Vec3::Zero();
    };
    struct Ring {
        core::Vec3 toMiddle = core::Vec3::Zero(); ///< from the tip
        double radius2_m2 = 0.0;
    };
    using Rings = std::array<Ring, kAhead>;

    std::size_t ringsAhead(const core::Vec3& p_A, const CentrelineFoot& foot, Rings& rings) const noexcept;
    static bool passes(const Rings& rings, std::size_t target) noexcept;

    UrethraWall m_wall;
    double m_cosHalfView;
    std::vector<Station> m_stations; ///< from the entrance to the bladder's centre, kStep_m apart
};

} // namespace chiron::simulation
