// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QString>

class QComboBox;
class QLabel;
class QLineEdit;
class QVBoxLayout;
class QWidget;

namespace chiron::desktop {

class AppContext;

namespace form {

/// A field under its label, in the layout; the label is its accessible name. GUI thread.
QLineEdit* textField(const Theme& theme, QVBoxLayout* layout, const QString& label, const QString& objectName);
QLineEdit* passwordField(const Theme& theme, QVBoxLayout* layout, const QString& label, const QString& objectName);

/// Puts a property "kind" on a widget that is shown already, so that its style follows.
void setKind(QWidget* widget, const char* kind);

/// The choice of language, each in its own words: for the screens before anybody is logged in.
QComboBox* languageChoice(AppContext& context);

} // namespace form
} // namespace chiron::desktop
