// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"

namespace chiron::simulation {

/// P2's building blocks as tables for the command line (evaluate_laws.h), one for each law of this folder.
/// Where a law has a state, the row also gives the history: `deformation` is held at a depth until held_s and
/// then let go for released_s; `bristle-friction` makes one step, from the given stretch of the bristle (0 at
/// first contact) by a displacement. The data are static.
/// Thread: any.
core::LawDescription elasticityLaw() noexcept;       ///< f = −k x
core::LawDescription strainStiffeningLaw() noexcept; ///< f = −(k/b)(e^{bx} − 1)
core::LawDescription massLaw() noexcept;             ///< m g and, optionally, m a
core::LawDescription deformationLaw() noexcept;      ///< standard linear solid
core::LawDescription viscosityLaw() noexcept;        ///< f = −b v inside
core::LawDescription elasticTubeLaw() noexcept;      ///< tension and energy of a taut segment from its length
core::LawDescription roughnessLaw() noexcept;        ///< micro-height and its effect on a press
core::LawDescription bristleFrictionLaw() noexcept;  ///< one step of the clipped bristle

} // namespace chiron::simulation
