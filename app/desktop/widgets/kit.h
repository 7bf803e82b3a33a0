// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QString>
#include <QVBoxLayout>

namespace chiron::desktop::kit {

/// Small makers, so that every screen has the same labels, buttons and cards. All return widgets without a parent: put
/// them into a layout. `kind` is the style sheet's property (style_sheet.cpp). GUI thread.

/// A label that wraps and can be selected by the mouse where `selectable`.
QLabel* label(const Theme& theme, const QString& text, TextStyle style = TextStyle::body, const char* kind = "");
/// A label of one line that never wraps (table heads, numbers).
QLabel* line(const Theme& theme, const QString& text, TextStyle style = TextStyle::body, const char* kind = "");
/// kind: "", "primary", "danger", "quiet", "tile". `icon` is a Breeze name, may be empty.
QPushButton* button(const Theme& theme, const QString& text, const char* kind = "", const QString& icon = {});
/// A button that cannot be pressed now says why in its tool tip and to a screen reader; `reason` is empty when it can.
void allowUnless(QPushButton& button, const QString& reason);
/// A button of an icon only; `text` is its accessible name and tool tip.
QPushButton* iconButton(const Theme& theme, const QString& icon, const QString& text);

/// A framed box with padding and a vertical layout: kind "card", "raised", "good", "warning", "bad", "info".
struct Box {
    QFrame* frame = nullptr;
    QVBoxLayout* layout = nullptr;
};
Box box(const Theme& theme, const char* kind = "card");
QFrame* rule();

/// A path that a label may break after each slash (by a space of no width): it has no other place to be broken at.
QString breakablePath(QString path);

/// A notice: sign, text and kind ("good", "warning", "bad", "info"), so that colour is never alone.
QFrame* notice(const Theme& theme, const char* kind, const QString& text);

} // namespace chiron::desktop::kit
