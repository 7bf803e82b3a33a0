// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>

namespace chiron::desktop {

/// What there is to be heard at one moment: every word of it is on the screen too. Trivially copyable, for LatestValue.
struct SoundCues {
    double force_N = 0.0;       ///< tissue force on the tool
    double limit_N = 4.0;       ///< > 0; above it the warning sounds
    std::uint32_t contacts = 0; ///< contacts begun since the session's start: each one clicks
    bool audible = false;       ///< false: paused, stopped, muted or over; sounds fade within some milliseconds
};

static_assert(std::is_trivially_copyable_v<SoundCues>);

} // namespace chiron::desktop
