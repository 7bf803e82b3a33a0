// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/login/new_password_page.h"

#include "desktop/accounts/form.h"
#include "desktop/accounts/notice_area.h"
#include "desktop/accounts/password_fields.h"
#include "desktop/widgets/kit.h"

namespace chiron::desktop {

NewPasswordPage::NewPasswordPage(const Theme& theme, const QString& loginName, QWidget* parent)
    : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(12));
    column->addWidget(kit::label(theme, tr("Choose a password of your own"), TextStyle::heading));
    column->addWidget(kit::label(
        theme,
        tr("Your current password was set by someone else. From your next login, only the new one is valid."),
        TextStyle::body, "muted"));
    m_passwords = new PasswordFields(theme, QStringLiteral("change"));
    m_passwords->setLoginName(loginName);
    column->addWidget(m_passwords);
    auto* back = kit::button(theme, tr("Back"));
    back->setObjectName(QStringLiteral("change.back"));
    m_save = kit::button(theme, tr("Save and log in"), "primary");
    m_save->setObjectName(QStringLiteral("change.save"));
    const form::Foot foot = form::addFoot(theme, column, back, m_save);
    m_foot = foot.widget;
    m_notice = foot.notice;
    m_notice->setObjectName(QStringLiteral("change.notice"));
    connect(m_passwords, &PasswordFields::changed, this, &NewPasswordPage::renew);
    connect(m_passwords, &PasswordFields::submitted, this, &NewPasswordPage::submit);
    connect(m_save, &QPushButton::clicked, this, &NewPasswordPage::submit);
    connect(back, &QPushButton::clicked, this, &NewPasswordPage::backAsked);
    renew();
}

void NewPasswordPage::focusFirst() {
    m_passwords->focusFirst();
}

void NewPasswordPage::renew() {
    m_passwords->setEnabled(!m_working);
    m_save->setEnabled(!m_working && m_passwords->isGood());
    m_save->setText(m_working ? tr("Saving …") : tr("Save and log in"));
}

void NewPasswordPage::submit() {
    if (m_save->isEnabled())
        emit submitted(QString::fromStdString(m_passwords->password()));
}

void NewPasswordPage::setWorking(bool working) {
    m_working = working;
    if (working)
        m_notice->clear();
    renew();
}

void NewPasswordPage::showProblem(const QString& text) {
    m_notice->say("bad", text);
}

} // namespace chiron::desktop
