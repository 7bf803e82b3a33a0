// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::simulation {

/// All values from which a section of the drawn urethra is made: two equal sections have the same points, bit
/// for bit.
struct UrethraSection {
    double s_m = 0.0;
    double radius_m = 0.0;
    double ex_m = 0.0; ///< shift of its centre in its own plane, along x̂
    double en_m = 0.0; ///< the same along n
    /// ≥ 0: not a circle but the end of the deformation, on this span of the resting surface …
    int restSpan = -1;
    double restParameter = 0.0; ///< … at this parameter of the span

    bool operator==(const UrethraSection&) const = default;
};

} // namespace chiron::simulation
