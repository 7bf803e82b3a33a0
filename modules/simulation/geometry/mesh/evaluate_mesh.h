// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"

namespace chiron::simulation {

/// "mesh-contact" as a table for the command line (evaluate_laws.h): tool position and velocity → force, blended normal, depth and
/// energy on a generated mesh (an ellipsoid with bumps, or a dome on a plate). Each row stands alone: contact is acquired at
/// the nearest place, without history, friction or dents. A mesh that cannot be made gives rows of NaN. The mesh of the last
/// parameters is kept by the calling thread. Static data; thread: any but the haptic one.
core::LawDescription meshContactLaw() noexcept;

} // namespace chiron::simulation
