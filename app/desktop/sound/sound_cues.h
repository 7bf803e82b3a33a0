// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>

namespace chiron::desktop {

/// Which cues somebody wants to hear; each can be switched alone.
struct SoundSwitches {
    bool contact = true; ///< a click when contact begins
    bool force = true;   ///< the tone whose pitch rises with force
    bool lean = true;    ///< the tone turns brighter the farther the force leans
    bool warning = true; ///< over the limit
    bool operator==(const SoundSwitches&) const = default;
};

/// What there is to be heard at one moment: every word of it is on the screen too. Trivially copyable, for LatestValue.
struct SoundCues {
    double force_N = 0.0;       ///< tissue force on the tool
    double limit_N = 4.0;       ///< > 0; above it the warning sounds
    std::uint32_t contacts = 0; ///< contacts begun since the session's start: each one clicks
    double lean = 0.0;          ///< 0 upright .. 1 as far as a fingertip platform leans; 0 where nothing leans
    SoundSwitches on{};
    double masking = 0.0;       ///< 0..1: pink noise that covers a device's own sounds (studies); the other cues are silent then
    bool audible = false;       ///< false: paused, stopped, muted or over; sounds fade within some milliseconds
};

static_assert(std::is_trivially_copyable_v<SoundCues>);

} // namespace chiron::desktop
