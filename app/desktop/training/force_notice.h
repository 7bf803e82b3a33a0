// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "desktop/training/force_words.h"

#include <QFrame>

class QLabel;

namespace chiron::desktop {

/// Shows the state of the force as a notice with changing text and icon.
/// Thread: GUI.
class ForceNotice final : public QFrame {
    Q_OBJECT
public:
    explicit ForceNotice(const Theme& theme, QWidget* parent = nullptr);

    bool show(const ForceWords& words); ///< whether anything changed; cheap if nothing did
    const ForceWords& words() const noexcept { return m_words; }

private:
    const Theme& m_theme;
    ForceWords m_words;
    QLabel* m_sign;
    QLabel* m_title;
    QLabel* m_text;
};

} // namespace chiron::desktop
