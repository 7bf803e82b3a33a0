// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/repositories/study_types.h"

#include <string>
#include <vector>

namespace chiron::database {

/// Returns a blinded study's design for readers who may not know its conditions: with the same number of
/// conditions, in the order of `codes`, each titled by its code. Common properties are kept, so that runs can
/// be analysed; properties that differ have a neutral value that is in range.
/// Errors: badInput (a design that cannot be read is not shown).
core::Result<std::string> maskedDesign(const std::string& designJson, const Blinding& blinding,
                                       const std::vector<SealedCondition>& codes);

} // namespace chiron::database
