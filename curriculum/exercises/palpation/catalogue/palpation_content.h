// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/object_reader.h"

namespace chiron::catalogue {

/// simulation::PalpationParameters from content/schema/palpation_parameters.json's keys (mm there, m here).
ExerciseParameters readPalpation(const ObjectReader& parameters, const std::vector<std::string>& cues);

/// What no single key's range can say: low ≤ high; catch trials and others; lumps for which the law of models.md §3 is valid and
/// that fit into regions of their own; a tissue whose nearest point is one as deep as the force cap lets a finger come; at most
/// four fingers; a move of the lumps after which they are still in the area.
void checkPalpation(const ExerciseParameters& parameters, const QString& path, Problems& problems);

} // namespace chiron::catalogue
