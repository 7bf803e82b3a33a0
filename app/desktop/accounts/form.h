// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QString>

class QComboBox;
class QLabel;
class QLineEdit;
class QVBoxLayout;
class QPushButton;
class QWidget;

namespace chiron::desktop {

class AppContext;
class NoticeArea;

namespace form {

/// Adds an input field with a label above it to the layout. The label is also the field's accessible name.
/// Thread: GUI.
QLineEdit* textField(const Theme& theme, QVBoxLayout* layout, const QString& label,
                     const QString& objectName);
QLineEdit* passwordField(const Theme& theme, QVBoxLayout* layout, const QString& label,
                         const QString& objectName);

/// The foot of a form: its messages above a row of buttons. A PageFooter keeps it in sight.
struct Foot {
    QWidget* widget;
    NoticeArea* notice;
};
/// Adds a foot with two buttons to the layout: `back` at the left, `next` at the right.
Foot addFoot(const Theme& theme, QVBoxLayout* layout, QPushButton* back, QPushButton* next);

/// Sets the property "kind" of a widget that is already shown, and refreshes the widget's style.
void setKind(QWidget* widget, const char* kind);

/// The language selector for the screens before login. Each language is named in that language.
QComboBox* languageChoice(AppContext& context);

} // namespace form
} // namespace chiron::desktop
