// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/law_description.h"

namespace chiron::simulation {

/// P3's laws as tables for the command line (evaluate_laws.h). The data are static.
/// Thread: any.
core::LawDescription voigtLaw() noexcept;            ///< eq. 1
core::LawDescription palpationContactLaw() noexcept; ///< eq. 2 and 3, and how the platform shows the force
core::LawDescription palpationLumpLaw() noexcept;    ///< models.md §3: a lump under a flat surface

} // namespace chiron::simulation
