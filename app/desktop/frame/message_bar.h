// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/messages.h"
#include "desktop/theme/theme.h"

#include <QFrame>
#include <QPointer>

class QLabel;
class QPushButton;
class QTimer;

namespace chiron::desktop {

/// The message at the bottom of the window: sign, words, perhaps one action ("Undo"), close. Errors stay, others go. It lies in a room that
/// is kept for it, so that nothing moves and no control is covered when it comes or goes. Words that have no room there are shortened and shown
/// whole when asked for. Without a room (a sitting needs the whole window) it floats where no control is that can be used. GUI thread.
class MessageBar final : public QFrame {
    Q_OBJECT
public:
    /// Floats over `parent`, until it is given a room in it.
    explicit MessageBar(const Theme& theme, QWidget* parent = nullptr);
    void tell(const Message& message);
    /// `room` lies within the parent and outlives the bar, or is null.
    void setRoom(QWidget* room);

    /// The height that a room needs: of two lines, or a button.
    static int roomHeight(const Theme& theme);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override; ///< size and place of parent and room

private:
    void build();
    void settle();
    void rise();
    void fitText(int width, int height);
    int widthOfOthers() const;
    QRect freePlace() const;
    void showWhole();

    const Theme& m_theme;
    QPointer<QWidget> m_room;
    QLabel* m_sign = nullptr;
    QLabel* m_text = nullptr;
    QPushButton* m_more = nullptr;
    QPushButton* m_action = nullptr;
    QPushButton* m_close = nullptr;
    QTimer* m_timer = nullptr;
    QTimer* m_watch = nullptr; ///< while it floats: controls may come
    QString m_whole;
    std::function<void()> m_act;
};

} // namespace chiron::desktop
