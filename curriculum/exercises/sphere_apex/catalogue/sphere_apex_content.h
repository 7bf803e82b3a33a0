// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/object_reader.h"

namespace chiron::catalogue {

/// simulation::SphereApexParameters from content/schema/sphere_apex_parameters.json's keys (mm there, m
/// here).
ExerciseParameters readSphereApex(const ObjectReader& parameters, const std::vector<std::string>& cues);

/// low ≤ high; the sphere inside the workspace wherever its centre falls; a dimple on the ball that leaves
/// the apex.
void checkSphereApex(const ExerciseParameters& parameters, const QString& path, Problems& problems);

} // namespace chiron::catalogue
