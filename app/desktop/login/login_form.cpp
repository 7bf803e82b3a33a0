// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/login/login_form.h"

#include "desktop/accounts/account_words.h"
#include "desktop/accounts/form.h"
#include "desktop/accounts/notice_area.h"
#include "desktop/accounts/wait_countdown.h"
#include "desktop/login/name_list.h"
#include "desktop/widgets/kit.h"

#include <QLineEdit>

namespace chiron::desktop {

LoginForm::LoginForm(const Theme& theme, QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(12));
    m_hint = new NoticeArea(theme, NoticeArea::Room::none); // shown before the person points at anything
    column->addWidget(m_hint);
    m_names = new NameList(theme);
    column->addWidget(m_names);
    m_password = form::passwordField(theme, column, tr("Password"), QStringLiteral("login.password"));
    m_notice = new NoticeArea(theme);
    m_notice->setObjectName(QStringLiteral("login.notice"));
    column->addWidget(m_notice);
    m_enter = kit::button(theme, tr("Log in"), "primary");
    m_enter->setObjectName(QStringLiteral("login.enter"));
    column->addWidget(m_enter);
    m_forgotten = kit::button(theme, tr("Forgot your password?"), "quiet");
    m_forgotten->setObjectName(QStringLiteral("login.forgotten"));
    column->addWidget(m_forgotten, 0, Qt::AlignHCenter);
    m_wait = new WaitCountdown(this);
    connect(m_wait, &WaitCountdown::changed, this,
            [this](int seconds) { m_enter->setText(waitWords(seconds)); });
    connect(m_wait, &WaitCountdown::finished, this, [this] {
        renew();
        m_password->setFocus();
    });
    connect(m_names, &NameList::chosen, this, [this] { m_password->setFocus(); });
    connect(m_names, &NameList::nameChanged, this, &LoginForm::nameChanged);
    connect(m_password, &QLineEdit::textChanged, this, &LoginForm::renew);
    connect(m_password, &QLineEdit::returnPressed, this, &LoginForm::submit);
    connect(m_enter, &QPushButton::clicked, this, &LoginForm::submit);
    connect(m_forgotten, &QPushButton::clicked, this, &LoginForm::forgotten);
    renew();
}

void LoginForm::setNames(const std::vector<database::LoginName>& names) {
    m_names->setNames(names);
}

void LoginForm::showDemonstrationHint(const QString& text) {
    m_hint->say("info", text);
}

void LoginForm::renew() {
    const bool waits = m_wait->isRunning();
    m_names->setEnabled(!m_working);
    m_password->setEnabled(!m_working && !waits);
    m_enter->setEnabled(!m_working && !waits && !m_names->name().isEmpty() && !m_password->text().isEmpty());
    if (!waits)
        m_enter->setText(m_working ? tr("Checking …") : tr("Log in"));
}

/// Clears a message about another name, which would otherwise stand beside the list's message about this one.
void LoginForm::nameChanged() {
    if (m_saysOfName)
        m_notice->clear();
    m_saysOfName = false;
    renew();
}

void LoginForm::submit() {
    if (m_enter->isEnabled())
        emit submitted(m_names->name(), m_password->text());
}

void LoginForm::setWorking(bool working) {
    m_working = working;
    if (working)
        m_notice->clear();
    renew();
}

void LoginForm::showRefusal(const database::Refusal& refusal) {
    m_working = false;
    m_password->clear();
    m_notice->say(refusal.kind == database::Refusal::Kind::failed ? "bad" : "warning",
                  loginRefusalWords(refusal));
    m_saysOfName = refusal.kind != database::Refusal::Kind::failed;
    m_names->hideExplanation();
    m_wait->start(refusal.wait_ns);
    renew();
    if (m_password->isEnabled())
        m_password->setFocus();
    else
        setFocus(); // on no control, so that Return does nothing in the meantime
}

void LoginForm::clearPassword() {
    m_password->clear();
}

void LoginForm::focusFirst() {
    if (m_names->name().isEmpty())
        m_names->focusField();
    else
        m_password->setFocus();
}

QString LoginForm::name() const {
    return m_names->name();
}

void LoginForm::setName(const QString& name) {
    m_names->setName(name);
}

} // namespace chiron::desktop
