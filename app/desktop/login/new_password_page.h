// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QWidget>

class QPushButton;

namespace chiron::desktop {

class NoticeArea;
class PasswordFields;

/// Asks for a new password of the person's own after a login with a password that somebody else has set.
/// Thread: GUI.
class NewPasswordPage final : public QWidget {
    Q_OBJECT
public:
    NewPasswordPage(const Theme& theme, const QString& loginName, QWidget* parent = nullptr);
    /// The buttons and what is told beside them, for a PageFooter. They stand at the end of the page until
    /// somebody takes them.
    QWidget* foot() const { return m_foot; }
    void focusFirst();
    void setWorking(bool working);
    void showProblem(const QString& text);

signals:
    void submitted(const QString& password);
    void backAsked();

private:
    void renew();
    void submit();

    PasswordFields* m_passwords;
    QWidget* m_foot;
    NoticeArea* m_notice;
    QPushButton* m_save;
    bool m_working = false;
};

} // namespace chiron::desktop
