// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/theme/theme.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

/// The tokens are part of a static library, and the linker leaves out its resources unless they are
/// requested. The macro requires a function in the global namespace.
static void initialiseDesktopResources() {
    Q_INIT_RESOURCE(desktop);
}

namespace chiron::desktop {

namespace {

QString tokenOf(ThemeName name) {
    switch (name) {
    case ThemeName::light:
        return QStringLiteral("light");
    case ThemeName::dark:
        return QStringLiteral("dark");
    case ThemeName::highContrast:
        return QStringLiteral("high_contrast");
    }
    return {};
}

tl::unexpected<core::Error> bad(const QString& path, const QString& expected) {
    return core::fail(core::ErrorCode::badInput,
                      QStringLiteral("tokens.json: $.%1: expected %2").arg(path, expected).toStdString());
}

QStringList listOf(const QJsonValue& value) {
    QStringList list;
    for (const QJsonValue& entry : value.toArray())
        list << entry.toString();
    return list;
}

} // namespace

core::Result<Theme> Theme::load(ThemeName name, double scale) {
    initialiseDesktopResources();
    QFile file(QStringLiteral(":/theme/tokens.json"));
    if (!file.open(QIODevice::ReadOnly))
        return core::fail(core::ErrorCode::notFound, "tokens.json is not part of this program");
    return fromJson(file.readAll(), name, scale);
}

core::Result<Theme> Theme::fromJson(const QByteArray& json, ThemeName name, double scale) {
    const QJsonObject root = QJsonDocument::fromJson(json).object();
    const QString token = tokenOf(name);
    const QJsonObject colours = root.value(QStringLiteral("themes")).toObject().value(token).toObject();
    Theme theme;
    theme.m_name = name;
    theme.m_scale = qBound(1.0, scale, 2.0);
#define CHIRON_COLOUR(role)                                                                                  \
    theme.m_colours[static_cast<std::size_t>(Colour::role)] =                                                \
        QColor(colours.value(QStringLiteral(#role)).toString());                                             \
    if (!theme.color(Colour::role).isValid())                                                                \
        return bad(QStringLiteral("themes.%1.%2").arg(token, QStringLiteral(#role)),                         \
                   QStringLiteral("a colour #rrggbb"));
    CHIRON_THEME_COLOURS(CHIRON_COLOUR)
#undef CHIRON_COLOUR
    const QJsonObject sizes = root.value(QStringLiteral("text_px")).toObject();
    const QJsonObject weights = root.value(QStringLiteral("text_weight")).toObject();
#define CHIRON_STYLE(style)                                                                                  \
    theme.m_text_px[static_cast<std::size_t>(TextStyle::style)] =                                            \
        sizes.value(QStringLiteral(#style)).toInt();                                                         \
    theme.m_weight[static_cast<std::size_t>(TextStyle::style)] =                                             \
        weights.value(QStringLiteral(#style)).toInt();                                                       \
    if (theme.m_text_px[static_cast<std::size_t>(TextStyle::style)] < 8)                                     \
        return bad(QStringLiteral("text_px." #style), QStringLiteral("at least 8 pixels"));                  \
    if (theme.m_weight[static_cast<std::size_t>(TextStyle::style)] < 100)                                    \
        return bad(QStringLiteral("text_weight." #style), QStringLiteral("a weight from 100"));
    CHIRON_TEXT_STYLES(CHIRON_STYLE)
#undef CHIRON_STYLE
    theme.m_control_px = root.value(QStringLiteral("control_px")).toDouble();
    theme.m_radius_px = root.value(QStringLiteral("radius_px")).toDouble();
    theme.m_families = listOf(root.value(QStringLiteral("families")));
    theme.m_monoFamilies = listOf(root.value(QStringLiteral("mono_families")));
    if (theme.m_control_px < 24)
        return bad(QStringLiteral("control_px"), QStringLiteral("at least 24 pixels"));
    if (theme.m_families.isEmpty() || theme.m_monoFamilies.isEmpty())
        return bad(QStringLiteral("families"), QStringLiteral("at least one font family"));
    return theme;
}

QFont Theme::font(TextStyle style) const {
    QFont font;
    font.setFamilies(style == TextStyle::mono ? m_monoFamilies : m_families);
    font.setPixelSize(px(m_text_px[static_cast<std::size_t>(style)]));
    font.setWeight(static_cast<QFont::Weight>(m_weight[static_cast<std::size_t>(style)]));
    return font;
}

QPalette Theme::palette() const {
    QPalette palette;
    palette.setColor(QPalette::Window, color(Colour::window));
    palette.setColor(QPalette::WindowText, color(Colour::text));
    palette.setColor(QPalette::Base, color(Colour::surface));
    palette.setColor(QPalette::AlternateBase, color(Colour::raised));
    palette.setColor(QPalette::Text, color(Colour::text));
    palette.setColor(QPalette::Button, color(Colour::surface));
    palette.setColor(QPalette::ButtonText, color(Colour::text));
    palette.setColor(QPalette::BrightText, color(Colour::bad));
    palette.setColor(QPalette::ToolTipBase, color(Colour::raised));
    palette.setColor(QPalette::ToolTipText, color(Colour::text));
    palette.setColor(QPalette::PlaceholderText, color(Colour::muted));
    palette.setColor(QPalette::Highlight, color(Colour::accent));
    palette.setColor(QPalette::HighlightedText, color(Colour::accentText));
    palette.setColor(QPalette::Link, color(Colour::accent));
    palette.setColor(QPalette::LinkVisited, color(Colour::accent));
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, color(Colour::muted));
    return palette;
}

} // namespace chiron::desktop
