// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/object_reader.h"
#include "simulation/palpation/tissue_parameters.h"

namespace chiron::catalogue {

/// A tissue of content/tissues.
struct ContentTissue {
    std::string id; ///< file name without .json
    Translated title;
    std::string source; ///< where its numbers come from, or that they are assumptions
    simulation::TissueParameters parameters;
};

/// Reads a tissue from the parameters of an exercise: `"$ref": "tissue_properties.json"`, `"default":
/// {"tissue": "pad"}`. readObject() (object_content.h) describes how names and changes are resolved. A key
/// that is absent keeps the struct's default; an unknown key is a problem.
/// Unit: mm, kPa and degrees in the JSON; SI in the result.
simulation::TissueParameters readTissue(const ObjectReader& json);

/// Checks what the range of a single key cannot express: the surface must be so gently curved that its
/// nearest point is unique, and there must be a stiffness.
void checkTissue(const simulation::TissueParameters& tissue, const QString& path, Problems& problems);

} // namespace chiron::catalogue
