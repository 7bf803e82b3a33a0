// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"

namespace chiron::scene3d {

/// The appearance of a tissue; the force law does not depend on it.
enum class TissueLook {
    pad,   ///< cast silicone
    gland, ///< mucosa over a gland
    skin   ///< with an areola on its highest elevation
};

/// Derived from the name of the tissue's first layer ("silicone"; "skin" or "fat"); with any other name, a
/// flat tissue is a pad and any other tissue a gland.
TissueLook tissueLookOf(const simulation::TissueParameters& tissue);

/// The ring of darker skin: on the first region of normal anatomy if there is one, else on the highest
/// elevation.
/// Unit: m.
/// Frame: W.
struct Areola {
    core::Vec2 centre_m = core::Vec2::Zero();
    double radius_m = 0.0; ///< 0: none
};
Areola areolaOf(const simulation::TissueParameters& tissue);

/// The radius of the drawn field round W's origin: the search area with a margin for a finger beside it.
double palpationField_m(const simulation::PalpationParameters& parameters);

} // namespace chiron::scene3d
