// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/messages.h"
#include "desktop/theme/theme.h"

#include <QFrame>

class QLabel;
class QPushButton;
class QTimer;

namespace chiron::desktop {

/// The message at the bottom of the window: sign, words, perhaps one action ("Undo"), close. Errors stay, others go. It floats over its
/// parent, so that nothing moves when it comes or goes, and comes at the top where the pointer is at the bottom.
class MessageBar final : public QFrame {
    Q_OBJECT
public:
    explicit MessageBar(const Theme& theme, QWidget* parent = nullptr);
    void tell(const Message& message);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override; ///< the parent's size

private:
    void settle();
    void rise();


    const Theme& m_theme;
    QLabel* m_sign;
    QLabel* m_text;
    QPushButton* m_action;
    QPushButton* m_close;
    QTimer* m_timer;
    bool m_atTop = false;
    std::function<void()> m_act;
};

} // namespace chiron::desktop
