// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "simulation/geometry/urethra/urethra_anatomy.h"
#include "simulation/geometry/urethra/urethra_surface.h"

#include <string>
#include <vector>

namespace chiron::simulation {

/// One reason why an urethra cannot be: where (the member's name, e.g. "changes[1].radius_m", "mesh.n") and why, with the
/// value found and what was expected, in SI.
struct UrethraProblem {
    std::string field;
    std::string reason;
};

/// Everything that is wrong, in the order of the members; empty: the urethra can be simulated and drawn. Numbers out of
/// range; a wall that crosses itself (its radius, at rest or opened by the endoscope, reaches the centre-line's radius of curvature);
/// local changes outside the canal or over one another. An endoscope thinner than the urethra is allowed. Set-up, any thread.
std::vector<UrethraProblem> urethraProblems(const UrethraAnatomy& anatomy, const Endoscope& endoscope,
                                            const UrethraMeshSettings& mesh);

/// The same as one error (badInput) that names the first problem and how many more there are.
core::Result<void> checkUrethra(const UrethraAnatomy& anatomy, const Endoscope& endoscope,
                                const UrethraMeshSettings& mesh);

} // namespace chiron::simulation
