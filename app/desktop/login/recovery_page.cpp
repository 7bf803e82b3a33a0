// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/login/recovery_page.h"

#include "desktop/accounts/account_words.h"
#include "desktop/accounts/form.h"
#include "desktop/accounts/notice_area.h"
#include "desktop/accounts/password_fields.h"
#include "desktop/accounts/wait_countdown.h"
#include "desktop/widgets/kit.h"

#include <QLineEdit>

namespace chiron::desktop {

RecoveryPage::RecoveryPage(const Theme& theme, const QString& loginName, QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(12));
    column->addWidget(kit::label(theme, tr("Forgot your password?"), TextStyle::heading));
    column->addWidget(
        kit::notice(theme, "info",
                    tr("Ask an administrator of this site. Under People, they can give you a new password "
                       "with \"Reset password\". Your sessions and scores are kept.")));
    column->addWidget(kit::label(theme,
                                 tr("Administrators can use their recovery code. It was shown when the site "
                                    "was set up, or when they made one under My account."),
                                 TextStyle::body, "muted"));
    m_name = form::textField(theme, column, tr("Login name"), QStringLiteral("recovery.name"));
    m_name->setText(loginName);
    m_code = form::textField(theme, column, tr("Recovery code"), QStringLiteral("recovery.code_field"));
    m_code->setPlaceholderText(QStringLiteral("XXXXX-XXXXX-XXXXX-XXXXX-XXXXX"));
    m_passwords = new PasswordFields(theme, QStringLiteral("recovery"));
    column->addWidget(m_passwords);
    auto* back = kit::button(theme, tr("Back"));
    back->setObjectName(QStringLiteral("recovery.back"));
    m_save = kit::button(theme, tr("Set the password"), "primary");
    m_save->setObjectName(QStringLiteral("recovery.save"));
    const form::Foot foot = form::addFoot(theme, column, back, m_save);
    m_foot = foot.widget;
    m_notice = foot.notice;
    m_notice->setObjectName(QStringLiteral("recovery.notice"));
    m_wait = new WaitCountdown(this);
    connect(m_wait, &WaitCountdown::changed, this,
            [this](int seconds) { m_save->setText(waitWords(seconds)); });
    connect(m_wait, &WaitCountdown::finished, this, &RecoveryPage::renew);
    connect(m_name, &QLineEdit::textChanged, this, [this] { m_passwords->setLoginName(m_name->text()); });
    connect(m_name, &QLineEdit::textChanged, this, &RecoveryPage::renew);
    connect(m_code, &QLineEdit::textChanged, this, &RecoveryPage::renew);
    connect(m_code, &QLineEdit::returnPressed, m_passwords, &PasswordFields::focusFirst);
    connect(m_passwords, &PasswordFields::changed, this, &RecoveryPage::renew);
    connect(m_passwords, &PasswordFields::submitted, this, &RecoveryPage::submit);
    connect(m_save, &QPushButton::clicked, this, &RecoveryPage::submit);
    connect(back, &QPushButton::clicked, this, &RecoveryPage::backAsked);
    m_passwords->setLoginName(loginName);
    renew();
}

void RecoveryPage::focusFirst() {
    (m_name->text().isEmpty() ? m_name : m_code)->setFocus();
}

void RecoveryPage::renew() {
    const bool waits = m_wait->isRunning();
    for (QWidget* part :
         {static_cast<QWidget*>(m_name), static_cast<QWidget*>(m_code), static_cast<QWidget*>(m_passwords)})
        part->setEnabled(!m_working && !waits);
    m_save->setEnabled(!m_working && !waits && !m_name->text().isEmpty() &&
                       !m_code->text().trimmed().isEmpty() && m_passwords->isGood());
    if (!waits)
        m_save->setText(m_working ? tr("Checking …") : tr("Set the password"));
}

void RecoveryPage::submit() {
    if (m_save->isEnabled())
        emit submitted(m_name->text(), m_code->text().trimmed().toUpper(),
                       QString::fromStdString(m_passwords->password()));
}

void RecoveryPage::setWorking(bool working) {
    m_working = working;
    if (working)
        m_notice->clear();
    renew();
}

void RecoveryPage::showRefusal(const database::Refusal& refusal) {
    m_working = false;
    m_notice->say("warning", recoveryRefusalWords(refusal));
    m_wait->start(refusal.wait_ns);
    renew();
}

} // namespace chiron::desktop
