// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/repositories/study_types.h"

#include <string>
#include <vector>

namespace chiron::database {

/// A blinded study's design for those who may not know its conditions: as many of them, in the order of `codes`, each titled by its code. What
/// they have in common stays, so that runs are analysed by it; what they differ in has a value that is in range and says nothing.
/// Failure: badInput (a design that does not read shows nothing).
core::Result<std::string> maskedDesign(const std::string& designJson, const Blinding& blinding, const std::vector<SealedCondition>& codes);

} // namespace chiron::database
