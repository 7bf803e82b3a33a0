// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QWidget>

class QLabel;

namespace chiron::desktop {

/// Room for one notice in a form. The room is there while there is nothing to say, so that no button moves under the pointer when something
/// is said. Screen readers hear it through its accessible name. GUI thread.
class NoticeArea : public QWidget {
    Q_OBJECT
public:
    enum class Room {
        kept, ///< of a notice of two lines, and of the longest one so far
        none  ///< where nothing stands below it
    };
    explicit NoticeArea(const Theme& theme, Room room = Room::kept, QWidget* parent = nullptr);

    /// kind: "good", "warning", "bad", "info". An empty text hides it.
    void say(const char* kind, const QString& text);
    void clear() { say("info", {}); }
    QString text() const { return m_text; }

private:
    const Theme& m_theme;
    Room m_room;
    QWidget* m_notice = nullptr;
    QString m_text;
};

} // namespace chiron::desktop
