// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"

namespace chiron::simulation {

/// The law "urethra-force" for the command line's `evaluate`: it computes every component of UrethraResponse
/// from pose and velocity of the endoscope in A. Anatomy (with one local change), endoscope and grid are
/// parameters. The data are static. It builds its tables for each row and is therefore not for the tick.
/// Thread: any.
const core::LawDescription& urethraForceLaw() noexcept;

} // namespace chiron::simulation
