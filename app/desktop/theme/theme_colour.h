// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::desktop {

// clang-format off
/// The roles of colours. Each theme in tokens.json defines all of them by the same names.
#define CHIRON_THEME_COLOURS(X)                                                       \
    X(window) X(surface) X(raised) X(sidebar) X(sidebarText) X(sidebarActive)         \
    X(border) X(borderStrong) X(text) X(muted)                                        \
    X(accent) X(accentText) X(accentHover) X(accentSoft) X(focus)                     \
    X(good) X(goodSoft) X(warning) X(warningSoft) X(bad) X(badSoft)                   \
    X(danger) X(dangerText)                                                           \
    X(seriesA) X(seriesB) X(seriesC) X(overFill) X(grid)                              \
    X(sceneBackground) X(sceneField) X(ghost)
// clang-format on

enum class Colour {
#define CHIRON_COLOUR(name) name,
    CHIRON_THEME_COLOURS(CHIRON_COLOUR)
#undef CHIRON_COLOUR
        count
};

/// Text styles. tokens.json defines size (logical pixels at 100 %) and weight of each.
#define CHIRON_TEXT_STYLES(X) X(small) X(body) X(label) X(strong) X(title) X(heading) X(display) X(mono)

enum class TextStyle {
#define CHIRON_STYLE(name) name,
    CHIRON_TEXT_STYLES(CHIRON_STYLE)
#undef CHIRON_STYLE
        count
};

enum class ThemeName { light, dark, highContrast };

} // namespace chiron::desktop
