// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QLineEdit;

namespace chiron::desktop {

/// Lets a person type over what the program suggested in a field: the suggestion is selected whenever the
/// field gets the focus, and by the first click into it. The next click places the cursor. It ends with the
/// first letter that somebody types. The field owns it. Thread: GUI.
class SuggestedText final : public QObject {
    Q_OBJECT
public:
    explicit SuggestedText(QLineEdit& field);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QLineEdit& m_field;
    bool m_clicked = false; ///< since the field got the focus or the suggestion
};

} // namespace chiron::desktop
