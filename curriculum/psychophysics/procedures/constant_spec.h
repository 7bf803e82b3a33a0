// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace chiron::psychophysics {

class ProcedureKind;

/// Constant stimuli: the same levels for every participant, each presented the same number of times.
struct ConstantSpec {
    static constexpr std::string_view kKind = "constant";
    static const ProcedureKind& kind();
    std::vector<double> levels;
    int repeats = 20;
    /// Shuffled in blocks that contain each level once; otherwise in the order given.
    bool shuffled = true;
};

} // namespace chiron::psychophysics
