// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QWidget>

class QLabel;

namespace chiron::desktop {

/// Reserves the room for one notice in a form. The room stays reserved while the notice is empty, so that no
/// button moves under the pointer when a notice appears. Screen readers read the notice from its accessible
/// name.
/// Thread: GUI.
class NoticeArea : public QWidget {
    Q_OBJECT
public:
    enum class Room {
        kept, ///< room for two lines, or for the longest notice so far
        none  ///< no reserved room, for a form with nothing below the notice
    };
    explicit NoticeArea(const Theme& theme, Room room = Room::kept, QWidget* parent = nullptr);

    /// `kind` is "good", "warning", "bad" or "info". An empty text hides the notice.
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
