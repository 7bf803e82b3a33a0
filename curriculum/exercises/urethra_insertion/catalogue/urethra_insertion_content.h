// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/object_reader.h"

#include <QByteArray>

namespace chiron::catalogue {

/// Returns content/schema/urethra_insertion_parameters.json, made of the rows from which the parameters are
/// read.
QByteArray urethraInsertionSchema();

/// Reads simulation::UrethraInsertionParameters from the keys of
/// content/schema/urethra_insertion_parameters.json.
/// Unit: mm, degrees and Fr in the JSON; SI in the result.
ExerciseParameters readUrethraInsertion(const ObjectReader& parameters, const std::vector<std::string>& cues);

/// Checks what the range of a single key cannot express: a canal that does not intersect itself, local
/// changes that lie inside it, a bladder into which the endoscope fits, goals that can be reached, and
/// landmarks that can be seen.
void checkUrethraInsertion(const ExerciseParameters& parameters, const QString& path, Problems& problems);

} // namespace chiron::catalogue
