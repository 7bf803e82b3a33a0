// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"

namespace chiron::simulation {

/// The urethra's geometry as tables for the command line's `evaluate`. The data are static. An invalid
/// anatomy (urethraProblems()) and positions outside the canal give NaN. Not for use in the tick.
/// Thread: any.

/// "urethra-centreline": s → z, y, ψ, curvature, and the arc length that remains to the bladder neck.
const core::LawDescription& urethraCentrelineLaw() noexcept;
/// "urethra-profile": s → the wall's local values and its windows with the tip at `tip_s_m` (UrethraWall).
const core::LawDescription& urethraProfileLaw() noexcept;
/// "urethra-surface": s and angle → point and normal of the drawn wall (UrethraCurveNet, double precision).
const core::LawDescription& urethraSurfaceLaw() noexcept;

} // namespace chiron::simulation
