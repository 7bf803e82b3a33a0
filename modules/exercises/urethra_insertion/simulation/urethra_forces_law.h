// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"

namespace chiron::simulation {

/// "urethra-force" for the command line's `evaluate`: pose and velocity of the endoscope in A → every component of
/// UrethraResponse; anatomy (with one local change), endoscope and grid as parameters. Static data; thread: any. It builds its
/// tables for each row, so it is not for the tick.
const core::LawDescription& urethraForceLaw() noexcept;

} // namespace chiron::simulation
