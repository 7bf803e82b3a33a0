// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"

namespace chiron::simulation {

/// P2's building blocks as tables for the command line (evaluate_laws.h), one a law of this folder. Where a law has a state,
/// the row says what came before: `deformation` is held at a depth since held_s and then let go for released_s;
/// `bristle-friction` is one step, from the stretch that the row before gave (0 at first) by a displacement. Static data;
/// thread: any.
core::LawDescription elasticityLaw() noexcept;       ///< f = −k x
core::LawDescription strainStiffeningLaw() noexcept; ///< f = −(k/b)(e^{bx} − 1)
core::LawDescription massLaw() noexcept;             ///< m g, and m a
core::LawDescription deformationLaw() noexcept;      ///< standard linear solid
core::LawDescription viscosityLaw() noexcept;        ///< f = −b v inside
core::LawDescription elasticTubeLaw() noexcept;      ///< tension and energy of a taut segment from its length
core::LawDescription roughnessLaw() noexcept;        ///< micro-height and what it does to a press
core::LawDescription bristleFrictionLaw() noexcept;  ///< one step of the clipped bristle

} // namespace chiron::simulation
