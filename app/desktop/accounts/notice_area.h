// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QWidget>

class QLabel;

namespace chiron::desktop {

/// Room for one notice in a form: hidden while there is nothing to say. Screen readers hear it through its accessible
/// name. GUI thread.
class NoticeArea : public QWidget {
    Q_OBJECT
public:
    explicit NoticeArea(const Theme& theme, QWidget* parent = nullptr);

    /// kind: "good", "warning", "bad", "info". An empty text hides it.
    void say(const char* kind, const QString& text);
    void clear() { say("info", {}); }
    QString text() const { return m_text; }

private:
    const Theme& m_theme;
    QWidget* m_notice = nullptr;
    QString m_text;
};

} // namespace chiron::desktop
