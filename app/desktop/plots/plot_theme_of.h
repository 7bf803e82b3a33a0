// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "report/plot_theme.h"

namespace chiron::desktop {

/// The colours, fonts and number locale of plots on the screen, from the theme's tokens.
/// Thread: GUI.
report::PlotTheme plotThemeOf(const Theme& theme, const QLocale& locale);

} // namespace chiron::desktop
