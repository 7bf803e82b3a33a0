// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "simulation/geometry/urethra/urethra_anatomy.h"
#include "simulation/geometry/urethra/urethra_surface.h"

#include <string>
#include <vector>

namespace chiron::simulation {

/// One reason why a urethra is invalid: the field (the member's name, e.g. "changes[1].radius_m", "mesh.n")
/// and the reason, with the value found and what was expected, in SI units.
struct UrethraProblem {
    std::string field;
    std::string reason;
};

/// Returns all problems in the order of the members; if there are none, the urethra can be simulated and
/// drawn. It checks for numbers out of range, a wall that crosses itself (its radius, at rest or opened by
/// the endoscope, reaches the centre-line's radius of curvature), and local changes that lie outside the
/// canal or overlap. An endoscope thinner than the urethra is allowed. For set-up.
/// Thread: any.
std::vector<UrethraProblem> urethraProblems(const UrethraAnatomy& anatomy, const Endoscope& endoscope,
                                            const UrethraMeshSettings& mesh);

/// Returns the same as one error (badInput) that names the first problem and the number of further ones.
core::Result<void> checkUrethra(const UrethraAnatomy& anatomy, const Endoscope& endoscope,
                                const UrethraMeshSettings& mesh);

} // namespace chiron::simulation
