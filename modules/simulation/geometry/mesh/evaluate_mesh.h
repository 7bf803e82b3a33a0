// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"

namespace chiron::simulation {

/// The law "mesh-contact" as a table for the command line (evaluate_laws.h). It computes force, blended
/// normal, depth and energy from the tool's position and velocity on a generated mesh (an ellipsoid with
/// bumps, or a dome on a plate). Each row stands alone: contact is acquired at the nearest place, without
/// history, friction or dents. A mesh that cannot be made gives rows of NaN. The calling thread keeps the
/// mesh of the last parameters. The data are static.
/// Thread: any but the haptic one.
core::LawDescription meshContactLaw() noexcept;

} // namespace chiron::simulation
