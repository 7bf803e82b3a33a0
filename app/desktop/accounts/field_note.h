// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QObject>
#include <QString>

class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace chiron::desktop {

/// Shows what is wrong with an input field directly below the field, and hides it once the field is changed.
/// Construct it right after the field, because it is a child of the field. Use it in forms whose buttons lie
/// outside the page: there the note moves nothing that could be under the pointer.
/// Thread: GUI.
class FieldNote final : public QObject {
    Q_OBJECT
public:
    /// The note's label is named after the field, for example "restore.password.note".
    FieldNote(const Theme& theme, QVBoxLayout& layout, QLineEdit& field);

    /// Marks the field, selects its content and gives it the focus. Screen readers read the text aloud.
    void say(const QString& text);
    void clear();

private:
    QLineEdit& m_field;
    QLabel* m_label;
};

} // namespace chiron::desktop
