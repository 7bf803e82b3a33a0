// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/object_reader.h"

#include <QByteArray>

namespace chiron::catalogue {

/// Returns content/schema/sphere_apex_parameters.json, made of the rows from which the parameters are read.
QByteArray sphereApexSchema();

/// Reads simulation::SphereApexParameters from the keys of content/schema/sphere_apex_parameters.json.
/// Unit: mm in the JSON; m in the result.
ExerciseParameters readSphereApex(const ObjectReader& parameters, const std::vector<std::string>& cues);

/// Checks what the range of a single key cannot express: low ≤ high, a sphere that is inside the workspace
/// wherever its centre falls, and a dimple on the ball that leaves the apex intact.
void checkSphereApex(const ExerciseParameters& parameters, const QString& path, Problems& problems);

} // namespace chiron::catalogue
