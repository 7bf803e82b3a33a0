// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/lock/lock_cover.h"

#include "desktop/accounts/account_words.h"
#include "desktop/accounts/form.h"
#include "desktop/accounts/notice_area.h"
#include "desktop/accounts/wait_countdown.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"

#include <QLineEdit>

namespace chiron::desktop {

namespace {

void addHead(const Theme& theme, QVBoxLayout& column, const QString& name) {
    auto* sign = new QLabel;
    sign->setPixmap(
        theme.icon(QStringLiteral("system-lock-screen"), Colour::accent).pixmap(theme.px(44), theme.px(44)));
    sign->setAlignment(Qt::AlignCenter);
    column.addWidget(sign);
    auto* heading = kit::label(theme, LockCover::tr("Locked"), TextStyle::heading);
    heading->setAlignment(Qt::AlignCenter);
    column.addWidget(heading);
    auto* words = kit::label(
        theme,
        LockCover::tr("%1 is logged in. Everything keeps running and nothing is lost; only the screen is "
                      "covered.")
            .arg(name),
        TextStyle::body, "muted");
    words->setAlignment(Qt::AlignCenter);
    column.addWidget(words);
}

} // namespace

LockCover::LockCover(const Theme& theme, const QString& name, QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("lock.cover"));
    setProperty("kind", QStringLiteral("page"));
    setAttribute(Qt::WA_StyledBackground);
    setAutoFillBackground(true);
    auto* page = new ScrollPage(theme, 460);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(page);
    const kit::Box box = kit::box(theme);
    const int padding = theme.px(28);
    box.layout->setContentsMargins(padding, padding, padding, padding);
    addHead(theme, *box.layout, name);
    m_password = form::passwordField(theme, box.layout, tr("Password of %1").arg(name),
                                     QStringLiteral("lock.password"));
    m_notice = new NoticeArea(theme);
    m_notice->setObjectName(QStringLiteral("lock.notice"));
    box.layout->addWidget(m_notice);
    m_unlock = kit::button(theme, tr("Unlock"), "primary");
    m_unlock->setObjectName(QStringLiteral("lock.unlock"));
    box.layout->addWidget(m_unlock);
    auto* other = kit::button(theme, tr("Switch user"), "quiet", QStringLiteral("system-switch-user"));
    other->setObjectName(QStringLiteral("lock.switch"));
    box.layout->addWidget(other, 0, Qt::AlignHCenter);
    page->column()->addStretch(1);
    page->column()->addWidget(box.frame);
    page->column()->addStretch(1);
    m_wait = new WaitCountdown(this);
    connect(m_wait, &WaitCountdown::changed, this,
            [this](int seconds) { m_unlock->setText(waitWords(seconds)); });
    connect(m_wait, &WaitCountdown::finished, this, [this] {
        renew();
        m_password->setFocus();
    });
    connect(m_password, &QLineEdit::textChanged, this, &LockCover::renew);
    connect(m_password, &QLineEdit::returnPressed, this, &LockCover::submit);
    connect(m_unlock, &QPushButton::clicked, this, &LockCover::submit);
    connect(other, &QPushButton::clicked, this, &LockCover::switchAsked);
    renew();
}

void LockCover::focusFirst() {
    m_password->setFocus();
}

void LockCover::renew() {
    const bool waits = m_wait->isRunning();
    m_password->setEnabled(!m_working && !waits);
    m_unlock->setEnabled(!m_working && !waits && !m_password->text().isEmpty());
    if (!waits)
        m_unlock->setText(m_working ? tr("Checking …") : tr("Unlock"));
}

void LockCover::submit() {
    if (m_unlock->isEnabled())
        emit submitted(m_password->text());
}

void LockCover::setWorking(bool working) {
    m_working = working;
    if (working)
        m_notice->clear();
    renew();
}

void LockCover::showRefusal(const database::Refusal& refusal) {
    m_working = false;
    m_password->clear();
    m_notice->say("warning", refusalWords(refusal));
    m_wait->start(refusal.wait_ns);
    renew();
    if (m_password->isEnabled())
        m_password->setFocus();
    else
        setFocus(); // on no control, so that Return does nothing in the meantime
}

} // namespace chiron::desktop
