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

/// For a kind of exercise whose parameters hold a tissue: `"$ref": "tissue_properties.json"`, `"default": {"tissue": "pad"}`; see
/// readObject() (object_content.h) for how names and changes are resolved. What is not there keeps the struct's default, an
/// unknown key is a problem. mm, kPa, degrees there, SI here.
simulation::TissueParameters readTissue(const ObjectReader& json);

/// What no single key's range can say: a surface whose curvature is gentle enough for its nearest point to be one; a stiffness
/// there is.
void checkTissue(const simulation::TissueParameters& tissue, const QString& path, Problems& problems);

} // namespace chiron::catalogue
