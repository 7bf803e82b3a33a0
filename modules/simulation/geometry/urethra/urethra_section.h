// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::simulation {

/// What a section of the drawn urethra is made from, and all of it: two equal sections have the same points,
/// bit for bit.
struct UrethraSection {
    double s_m = 0.0;
    double radius_m = 0.0;
    double ex_m = 0.0; ///< shift of its centre in its own plane: x̂
    double en_m = 0.0; ///< and n
    int restSpan = -1; ///< ≥ 0: not a circle but where the deformation ends, on the resting surface's span …
    double restParameter = 0.0; ///< … at this parameter

    bool operator==(const UrethraSection&) const = default;
};

} // namespace chiron::simulation
