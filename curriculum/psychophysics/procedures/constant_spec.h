// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace chiron::psychophysics {

class ProcedureKind;

/// The same levels for everybody, each so often.
struct ConstantSpec {
    static constexpr std::string_view kKind = "constant";
    static const ProcedureKind& kind();
    std::vector<double> levels;
    int repeats = 20;
    bool shuffled = true; ///< by blocks of one of each level; else in the order given
};

} // namespace chiron::psychophysics
