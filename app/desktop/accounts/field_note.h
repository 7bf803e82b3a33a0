// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QObject>
#include <QString>

class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace chiron::desktop {

/// What is wrong with a field, said directly below it; gone once the field is changed. Make it right after the field, whose child it is.
/// For forms in which nothing below can be under the pointer when it is said (buttons outside the page). GUI thread.
class FieldNote final : public QObject {
    Q_OBJECT
public:
    /// Its label is named after the field: "restore.password.note".
    FieldNote(const Theme& theme, QVBoxLayout& layout, QLineEdit& field);

    /// Marks the field, selects what is in it and gives it the focus. Screen readers hear the words.
    void say(const QString& text);
    void clear();

private:
    QLineEdit& m_field;
    QLabel* m_label;
};

} // namespace chiron::desktop
