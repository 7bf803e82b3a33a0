// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"

#include <span>

namespace chiron::simulation {

/// The laws of this module that the command line can evaluate over a table; the list is modules/exercises/law_catalogue.cpp, and each law's
/// own header says what goes in and comes out. Static data; thread: any.
std::span<const core::LawDescription> evaluateLaws() noexcept;

} // namespace chiron::simulation
