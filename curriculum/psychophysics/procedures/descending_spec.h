// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace chiron::psychophysics {

class ProcedureKind;

/// P2's descending rule: the difference shrinks until the participant fails. "legacy": it overestimates the
/// JND (psychophysics.md §1).
struct DescendingSpec {
    static constexpr std::string_view kKind = "descending";
    static const ProcedureKind& kind();
    std::vector<double> levels; ///< descending
    int repeats = 3;            ///< presentations per level
    int passes = 2;             ///< right answers needed to go on
};

} // namespace chiron::psychophysics
