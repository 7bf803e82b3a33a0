// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"

namespace chiron::simulation {

/// The urethra's geometry for the command line's `evaluate`. Static data; thread: any; not for the tick. An
/// anatomy that cannot be (urethraProblems()) and places outside the canal give NaN.

/// "urethra-centreline": s → z, y, ψ, curvature, and what is left to the bladder neck.
const core::LawDescription& urethraCentrelineLaw() noexcept;
/// "urethra-profile": s → the wall's local values and its windows with the tip at `tip_s_m` (UrethraWall).
const core::LawDescription& urethraProfileLaw() noexcept;
/// "urethra-surface": s and angle → point and normal of the drawn wall (UrethraCurveNet, double precision).
const core::LawDescription& urethraSurfaceLaw() noexcept;

} // namespace chiron::simulation
