// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>

namespace chiron::desktop {

/// The cues that the person wants to hear. Each can be switched separately.
struct SoundSwitches {
    bool contact = true; ///< a click when contact begins
    bool force = true;   ///< the tone whose pitch rises with force
    bool lean = true;    ///< the tone turns brighter the farther the force leans
    bool warning = true; ///< over the limit
    bool operator==(const SoundSwitches&) const = default;
};

/// The cues to be heard at one moment. The screen shows all of them as well. Trivially copyable, for
/// LatestValue.
struct SoundCues {
    double force_N = 0.0;       ///< tissue force on the tool
    double limit_N = 4.0;       ///< > 0; above it the warning sounds
    std::uint32_t contacts = 0; ///< contacts since the start of the session; each increment gives a click
    double lean = 0.0; ///< how far a fingertip platform leans: 0 upright .. 1 maximum; 0 if nothing leans.
    SoundSwitches on{};
    /// 0..1: level of pink noise that covers a device's own sounds (in studies); the other cues are silent
    /// then.
    double masking = 0.0;
    /// False while paused, stopped, muted or over; sounds then fade within a few milliseconds.
    bool audible = false;
};

static_assert(std::is_trivially_copyable_v<SoundCues>);

} // namespace chiron::desktop
