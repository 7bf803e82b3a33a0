// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "desktop/theme/theme_colour.h"

#include <QColor>
#include <QFont>
#include <QIcon>
#include <QPalette>
#include <QString>
#include <QStringList>
#include <array>

namespace chiron::desktop {

/// Colours, fonts and lengths of one theme at one scale, all from resources/theme/tokens.json. The value is
/// immutable: another theme or scale is another Theme, with which the window is rebuilt.
/// Thread: GUI.
class Theme {
public:
    /// Loads a theme from the token file.
    /// Errors: badInput if the file lacks a name or holds a bad value; the message names it.
    static core::Result<Theme> load(ThemeName name, double scale);
    /// The same from other JSON text (for tests).
    static core::Result<Theme> fromJson(const QByteArray& json, ThemeName name, double scale);

    ThemeName name() const noexcept { return m_name; }
    double scale() const noexcept { return m_scale; } ///< 1..2
    bool isDark() const { return color(Colour::window).lightness() < 128; }
    QColor color(Colour role) const { return m_colours[static_cast<std::size_t>(role)]; }
    QFont font(TextStyle style) const;
    /// Converts logical pixels at 100 % into this scale. Every length on the screen is converted here.
    int px(double at100Percent) const { return qRound(at100Percent * m_scale); }
    int controlHeight() const { return px(m_control_px); } ///< of a button or field
    int radius() const { return px(m_radius_px); }

    /// A Breeze icon by name, in this theme's text colour or the given one. Never null: a missing icon is
    /// drawn as a plain dot.
    QIcon icon(const QString& name, Colour ink = Colour::text) const;

    QPalette palette() const;
    /// The style sheet for all widgets. Screens need none of their own (widgets take dynamic properties, see
    /// README).
    QString styleSheet() const;

private:
    Theme() = default;

    ThemeName m_name = ThemeName::light;
    double m_scale = 1.0;
    double m_control_px = 36;
    double m_radius_px = 8;
    std::array<QColor, static_cast<std::size_t>(Colour::count)> m_colours;
    std::array<int, static_cast<std::size_t>(TextStyle::count)> m_text_px{};
    std::array<int, static_cast<std::size_t>(TextStyle::count)> m_weight{};
    QStringList m_families;
    QStringList m_monoFamilies;
};

} // namespace chiron::desktop
