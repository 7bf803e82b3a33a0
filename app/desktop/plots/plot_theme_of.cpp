// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/plots/plot_theme_of.h"

namespace chiron::desktop {

report::PlotTheme plotThemeOf(const Theme& theme, const QLocale& locale) {
    report::PlotTheme plot;
    plot.paper = theme.color(Colour::surface);
    plot.ink = theme.color(Colour::text);
    plot.muted = theme.color(Colour::muted);
    plot.rule = theme.color(Colour::border);
    plot.grid = theme.color(Colour::grid);
    plot.panel = theme.color(Colour::raised);
    plot.accent = theme.color(Colour::accent);
    plot.good = theme.color(Colour::good);
    plot.bad = theme.color(Colour::bad);
    plot.warning = theme.color(Colour::warning);
    plot.goodFill = theme.color(Colour::goodSoft);
    plot.badFill = theme.color(Colour::badSoft);
    plot.warningFill = theme.color(Colour::warningSoft);
    plot.overFill = theme.color(Colour::overFill);
    plot.seriesA = theme.color(Colour::seriesA);
    plot.seriesB = theme.color(Colour::seriesB);
    plot.seriesC = theme.color(Colour::seriesC);
    plot.seriesD = theme.color(Colour::ghost);
    plot.scale = theme.scale();
    const QStringList families = theme.font(TextStyle::body).families();
    plot.family = families.isEmpty() ? theme.font(TextStyle::body).family() : families.first();
    plot.locale = locale;
    return plot;
}

} // namespace chiron::desktop
