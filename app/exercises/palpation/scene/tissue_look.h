// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"

namespace chiron::scene3d {

/// What a tissue looks like; the force law knows nothing of it.
enum class TissueLook {
    pad,   ///< cast silicone
    gland, ///< mucosa over a gland
    skin   ///< with an areola on its highest elevation
};

/// By the name of its first layer ("silicone"; "skin" or "fat"); another one: a flat tissue is a pad, any other a gland.
TissueLook tissueLookOf(const simulation::TissueParameters& tissue);

/// The ring of darker skin: on the first region of normal anatomy where there is one, else on the highest elevation. W, metres.
struct Areola {
    core::Vec2 centre_m = core::Vec2::Zero();
    double radius_m = 0.0; ///< 0: none
};
Areola areolaOf(const simulation::TissueParameters& tissue);

/// Round W's origin: the search area with a little room for a finger beside it.
double palpationField_m(const simulation::PalpationParameters& parameters);

} // namespace chiron::scene3d
