// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QString>
#include <QStringList>
#include <QVBoxLayout>

class QTabBar;

namespace chiron::desktop::kit {

/// Factory functions that give all screens the same labels, buttons and cards. All return widgets without a
/// parent: put them into a layout. `kind` is the style sheet's property (style_sheet.cpp).
/// Thread: GUI.

/// A wrapping label.
QLabel* label(const Theme& theme, const QString& text, TextStyle style = TextStyle::body,
              const char* kind = "");
/// A single-line label that never wraps (table heads, numbers).
QLabel* line(const Theme& theme, const QString& text, TextStyle style = TextStyle::body,
             const char* kind = "");
/// kind: "", "primary", "danger", "quiet", "tile". `icon` is the name of a Breeze icon; may be empty.
QPushButton* button(const Theme& theme, const QString& text, const char* kind = "", const QString& icon = {});
/// Disables a button and states the reason in its tool tip and to screen readers; enables it if `reason` is
/// empty.
void allowUnless(QPushButton& button, const QString& reason);
/// A button with an icon only. `text` is its accessible name and tool tip.
QPushButton* iconButton(const Theme& theme, const QString& icon, const QString& text);

/// A bar of tabs over a page that is built anew for each. A click gives it the focus, because the page that
/// had it goes. `name` is its accessible name.
QTabBar* tabBar(const Theme& theme, const QString& name, const QStringList& tabs);

/// A framed box with padding and a vertical layout: kind "card", "raised", "good", "warning", "bad", "info".
struct Box {
    QFrame* frame = nullptr;
    QVBoxLayout* layout = nullptr;
};
Box box(const Theme& theme, const char* kind = "card");
QFrame* rule();

/// Adds a zero-width space after each slash of a path, so that a label can wrap it there; otherwise it could
/// not wrap at all.
QString breakablePath(QString path);

/// A notice with icon, text and kind ("good", "warning", "bad", "info"), so that colour never stands alone.
QFrame* notice(const Theme& theme, const char* kind, const QString& text);

} // namespace chiron::desktop::kit
