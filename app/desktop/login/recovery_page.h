// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"
#include "desktop/theme/theme.h"

#include <QWidget>

class QLineEdit;
class QPushButton;

namespace chiron::desktop {

class NoticeArea;
class PasswordFields;
class WaitCountdown;

/// Help with a forgotten password: whom to ask, and for an administrator a form for the recovery code.
/// Thread: GUI.
class RecoveryPage final : public QWidget {
    Q_OBJECT
public:
    RecoveryPage(const Theme& theme, const QString& loginName, QWidget* parent = nullptr);
    /// The buttons and what is told beside them, for a PageFooter. They stand at the end of the page until
    /// somebody takes them.
    QWidget* foot() const { return m_foot; }
    void focusFirst();
    void setWorking(bool working);
    void showRefusal(const database::Refusal& refusal);

signals:
    void submitted(const QString& name, const QString& code, const QString& newPassword);
    void backAsked();

private:
    void renew();
    void submit();

    QLineEdit* m_name;
    QLineEdit* m_code;
    PasswordFields* m_passwords;
    QWidget* m_foot;
    NoticeArea* m_notice;
    QPushButton* m_save;
    WaitCountdown* m_wait;
    bool m_working = false;
};

} // namespace chiron::desktop
