// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// What the set-up of a scene reads from the parameters of its level.
namespace chiron::simulation {

/// Returns the whole ticks of a duration, at least one.
inline std::uint64_t ticksOf(double seconds) noexcept {
    return static_cast<std::uint64_t>(std::max(1LL, std::llround(seconds / core::kTickSeconds)));
}

/// Returns whether a level's list of cues names `cue`.
inline bool hasCue(const std::vector<std::string>& cues, std::string_view cue) noexcept {
    return std::find(cues.begin(), cues.end(), cue) != cues.end();
}

} // namespace chiron::simulation
