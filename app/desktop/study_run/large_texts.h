// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

namespace chiron::desktop {

/// From this scale on the scene of a trial needs the room that nothing else needs: nothing is reserved for
/// what is not there, and what is told twice is told once.
inline bool areTextsLarge(const Theme& theme) {
    constexpr double kLargeTexts = 1.5;
    return theme.scale() >= kLargeTexts;
}

} // namespace chiron::desktop
