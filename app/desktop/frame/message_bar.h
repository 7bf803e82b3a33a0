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

/// The message at the bottom of the window: icon, text, an optional action ("Undo") and a close button.
/// Errors stay until they are closed, others disappear after a while. The bar lies in a reserved room, so
/// that showing or hiding a message moves nothing and covers no control. A text that is too long for it is
/// shortened and shown in full on request. Without a reserved room (training sessions and study runs need the
/// whole window) the bar floats where it covers no usable control.
/// Thread: GUI.
class MessageBar final : public QFrame {
    Q_OBJECT
public:
    /// The bar floats over `parent` until setRoom() gives it a room there.
    explicit MessageBar(const Theme& theme, QWidget* parent = nullptr);
    void tell(const Message& message);
    /// `room` lies within the parent and outlives the bar, or is null.
    void setRoom(QWidget* room);

    /// The height that a room needs for two lines of text or a button.
    static int roomHeight(const Theme& theme);

protected:
    /// Follows size and position of parent and room.
    bool eventFilter(QObject* watched, QEvent* event) override;

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
    QTimer* m_watch = nullptr; ///< runs while the bar floats, because controls may appear below it
    QString m_whole;
    std::function<void()> m_act;
};

} // namespace chiron::desktop
