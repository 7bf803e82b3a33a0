// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/messages.h"
#include "desktop/theme/theme.h"

#include <QFrame>

class QLabel;
class QPushButton;
class QTimer;

namespace chiron::desktop {

/// The message at the bottom of the window: sign, words, perhaps one action ("Undo"), close. Errors stay, others go.
class MessageBar final : public QFrame {
    Q_OBJECT
public:
    explicit MessageBar(const Theme& theme, QWidget* parent = nullptr);
    void tell(const Message& message);

private:
    const Theme& m_theme;
    QLabel* m_sign;
    QLabel* m_text;
    QPushButton* m_action;
    QPushButton* m_close;
    QTimer* m_timer;
    std::function<void()> m_act;
};

} // namespace chiron::desktop
