// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"

#include <span>

namespace chiron::simulation {

/// The laws of this module that the command line can evaluate over a table.
/// modules/exercises/law_catalogue.cpp lists the laws of all modules; the header of each law states its
/// inputs and outputs. The data is static.
/// Thread: any.
std::span<const core::LawDescription> evaluateLaws() noexcept;

} // namespace chiron::simulation
