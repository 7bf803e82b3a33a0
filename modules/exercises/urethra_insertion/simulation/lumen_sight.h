// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"

#include <array>
#include <cstddef>
#include <vector>

namespace chiron::simulation {

/// Determines how far ahead the centre of the lumen can be seen from the tip. The same rule serves scripted
/// operators and the guidance that is drawn in the picture:
/// - The centre-line ahead is sampled at points 2.5 mm apart, from 2.5 to 60 mm before the tip. Each point
///   carries its opened radius and the centre of the lumen, which near the tip lies with the endoscope
///   (centre-line + W e, models.md §1.1).
/// - A point can be seen if it lies in the field of view and the straight line to it from the tip passes
///   every nearer point within that point's radius. The result is the farthest such point; if there is none,
///   the picture shows only wall.
///
/// Before the entrance there is no wall; past the neck the lumen is the bladder's sphere. Constructed at
/// set-up; look() is called in the tick and takes about 0.2 µs.
/// Thread: haptic for look(), which allocates nothing.
class LumenSight {
public:
    static constexpr double kStep_m = 0.0025;
    static constexpr std::size_t kAhead = 24;

    explicit LumenSight(const UrethraInsertionParameters& parameters);

    struct View {
        bool open = false;
        core::Vec3 p_A = core::Vec3::Zero(); ///< the farthest visible centre of the lumen
    };
    /// `axis_A` is the unit vector along which the endoscope looks; `foot` is that of p_A.
    View look(const core::Vec3& p_A, const core::Vec3& axis_A, const CentrelineFoot& foot) const noexcept;

private:
    struct Station {
        double s_m = 0.0;
        double radius_m = 0.0; ///< at rest; past the neck that of the bladder
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
