// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace chiron::psychophysics {

class ProcedureKind;

/// P2's descending rule: difference shrinks until the participant fails. "legacy": overestimates the JND (psychophysics.md §1).
struct DescendingSpec {
    static constexpr std::string_view kKind = "descending";
    static const ProcedureKind& kind();
    std::vector<double> levels; ///< descending
    int repeats = 3;            ///< presentations a level
    int passes = 2;             ///< right ones needed to go on
};

} // namespace chiron::psychophysics
