// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace chiron::simulation {

/// The values that change from trial to trial of object handling: the truth that scoring needs.
struct ObjectHandlingTrial {
    static constexpr std::size_t kMaxObjects = 3;
    int objects = 1;
    /// x, y in W at the start.
    std::array<core::Vec2, kMaxObjects> place_m{core::Vec2::Zero(), core::Vec2::Zero(), core::Vec2::Zero()};
    std::array<double, kMaxObjects> mass_kg{};
    core::Vec2 target_m = core::Vec2::Zero(); ///< x, y in W
    int heaviest = 0;                         ///< object number, from 0
};

/// Least distance between two objects at the start, centre to centre (m): a jaw fits between them.
double objectSpacing_m(const ObjectHandlingParameters& parameters) noexcept;
/// Least distance of the target's centre from every object (m): no object lies in the target at the start.
double targetSpacing_m(const ObjectHandlingParameters& parameters) noexcept;

/// Plans every trial of a session from its seed, before the first tick. Objects and target are uniform over
/// the disc of radius `placesRadius_m` around W's origin, kept apart by the two spacings (drawn again until
/// they are; after 1000 draws they lie on a ring at equal angles). Masses are uniform in [low, high]; if both
/// are 0, the object's own mass applies. A weigh trial draws which object is the heaviest and lets it weigh
/// at least `massRatio` times the next. Each quantity has its own random stream ("object_handling.place",
/// ...). Pure; allocates.
std::vector<ObjectHandlingTrial> planObjectHandlingTrials(const ObjectHandlingParameters& parameters,
                                                          std::uint64_t seed);

} // namespace chiron::simulation
