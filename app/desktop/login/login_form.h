// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"
#include "desktop/theme/theme.h"

#include <QWidget>
#include <vector>

class QLineEdit;
class QPushButton;

namespace chiron::desktop {

class NameList;
class NoticeArea;
class WaitCountdown;

/// The login form: name, password, "Log in", and the message about a refused login. It is kept light, because
/// it is the first thing that is painted.
/// Thread: GUI.
class LoginForm final : public QWidget {
    Q_OBJECT
public:
    explicit LoginForm(const Theme& theme, QWidget* parent = nullptr);

    void setNames(const std::vector<database::LoginName>& names);
    void showDemonstrationHint(const QString& text);
    void setWorking(bool working); ///< true while the password is being checked
    void showRefusal(const database::Refusal& refusal);
    void clearPassword();
    void focusFirst();
    QString name() const;
    void setName(const QString& name);

signals:
    void submitted(const QString& name, const QString& password);
    void forgotten();

private:
    void renew();
    void nameChanged();
    void submit();

    NameList* m_names;
    QLineEdit* m_password;
    NoticeArea* m_hint;
    NoticeArea* m_notice;
    QPushButton* m_enter;
    QPushButton* m_forgotten;
    WaitCountdown* m_wait;
    bool m_working = false;
    bool m_saysOfName = false; ///< the notice concerns the name that was sent
};

} // namespace chiron::desktop
