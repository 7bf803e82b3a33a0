// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"
#include "desktop/theme/theme.h"

#include <QWidget>

class QLineEdit;
class QPushButton;

namespace chiron::desktop {

class NoticeArea;
class WaitCountdown;

/// The opaque cover of a locked window: who locked it, a field for their password, and "Switch user".
/// Thread: GUI.
class LockCover final : public QWidget {
    Q_OBJECT
public:
    LockCover(const Theme& theme, const QString& name, QWidget* parent);

    void focusFirst();
    void setWorking(bool working);
    void showRefusal(const database::Refusal& refusal);

signals:
    void submitted(const QString& password);
    void switchAsked();

private:
    void renew();
    void submit();

    QLineEdit* m_password;
    QPushButton* m_unlock;
    NoticeArea* m_notice;
    WaitCountdown* m_wait;
    bool m_working = false;
};

} // namespace chiron::desktop
