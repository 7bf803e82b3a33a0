// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/widgets/kit.h"

#include <QHBoxLayout>
#include <QTabBar>
#include <cstring>

namespace chiron::desktop::kit {

namespace {

Colour inkOf(const char* kind) {
    if (std::strcmp(kind, "primary") == 0)
        return Colour::accentText;
    if (std::strcmp(kind, "danger") == 0)
        return Colour::dangerText;
    if (std::strcmp(kind, "quiet") == 0)
        return Colour::accent;
    return Colour::text;
}

struct Sign {
    const char* icon;
    Colour ink;
};

Sign signOf(const char* kind) {
    if (std::strcmp(kind, "good") == 0)
        return {"dialog-ok-apply", Colour::good};
    if (std::strcmp(kind, "warning") == 0)
        return {"dialog-warning", Colour::warning};
    if (std::strcmp(kind, "bad") == 0)
        return {"dialog-error", Colour::bad};
    return {"dialog-information", Colour::accent};
}

} // namespace

QLabel* label(const Theme& theme, const QString& text, TextStyle style, const char* kind) {
    auto* label = line(theme, text, style, kind);
    label->setWordWrap(true);
    return label;
}

QLabel* line(const Theme& theme, const QString& text, TextStyle style, const char* kind) {
    auto* label = new QLabel(text);
    label->setFont(theme.font(style));
    label->setProperty("kind", QLatin1String(kind));
    // Names and comments come from people and must never be interpreted as markup.
    label->setTextFormat(Qt::PlainText);
    return label;
}

QPushButton* button(const Theme& theme, const QString& text, const char* kind, const QString& icon) {
    auto* button = new QPushButton(text);
    button->setFont(theme.font(TextStyle::label));
    button->setProperty("kind", QLatin1String(kind));
    button->setAutoDefault(false);
    if (!icon.isEmpty()) {
        button->setIcon(theme.icon(icon, inkOf(kind)));
        button->setIconSize(QSize(theme.px(20), theme.px(20)));
    }
    return button;
}

void allowUnless(QPushButton& button, const QString& reason) {
    button.setEnabled(reason.isEmpty());
    button.setToolTip(reason);
    button.setAccessibleDescription(reason);
}

QPushButton* iconButton(const Theme& theme, const QString& icon, const QString& text) {
    auto* made = button(theme, {}, "quiet", icon);
    made->setAccessibleName(text);
    made->setToolTip(text);
    return made;
}

QTabBar* tabBar(const Theme& theme, const QString& name, const QStringList& tabs) {
    auto* bar = new QTabBar;
    bar->setAccessibleName(name);
    bar->setFont(theme.font(TextStyle::body));
    bar->setDrawBase(false);
    bar->setExpanding(false);
    bar->setUsesScrollButtons(true);
    bar->setFocusPolicy(Qt::StrongFocus);
    for (const QString& tab : tabs)
        bar->addTab(tab);
    return bar;
}

Box box(const Theme& theme, const char* kind) {
    Box box;
    box.frame = new QFrame;
    box.frame->setProperty("kind", QLatin1String(kind));
    box.layout = new QVBoxLayout(box.frame);
    const int padding = theme.px(16);
    box.layout->setContentsMargins(padding, padding, padding, padding);
    box.layout->setSpacing(theme.px(10));
    return box;
}

QFrame* rule() {
    auto* rule = new QFrame;
    rule->setProperty("kind", QStringLiteral("rule"));
    return rule;
}

QString breakablePath(QString path) {
    return path.replace(QLatin1Char('/'), QStringLiteral("/\u200B"));
}

QFrame* notice(const Theme& theme, const char* kind, const QString& text) {
    auto* frame = new QFrame;
    frame->setProperty("kind", QLatin1String(kind));
    auto* row = new QHBoxLayout(frame);
    row->setContentsMargins(theme.px(12), theme.px(10), theme.px(12), theme.px(10));
    row->setSpacing(theme.px(10));
    const Sign sign = signOf(kind);
    auto* picture = new QLabel;
    picture->setPixmap(theme.icon(QLatin1String(sign.icon), sign.ink).pixmap(theme.px(22), theme.px(22)));
    row->addWidget(picture, 0, Qt::AlignTop);
    auto* words = label(theme, text, TextStyle::body);
    words->setObjectName(QStringLiteral("notice.text"));
    row->addWidget(words, 1);
    return frame;
}

} // namespace chiron::desktop::kit
