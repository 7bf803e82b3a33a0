// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/message_bar.h"

#include "desktop/widgets/kit.h"

#include <QHBoxLayout>
#include <QStyle>
#include <QTimer>

namespace chiron::desktop {

namespace {

constexpr int kShown_ms = 8000; // long enough to read two lines and reach for Undo

struct Look {
    const char* kind;
    const char* icon;
    Colour ink;
};

Look lookOf(MessageKind kind) {
    switch (kind) {
    case MessageKind::done:
        return {"good", "dialog-ok-apply", Colour::good};
    case MessageKind::information:
        return {"info", "dialog-information", Colour::accent};
    case MessageKind::warning:
        return {"warning", "dialog-warning", Colour::warning};
    case MessageKind::error:
        return {"bad", "dialog-error", Colour::bad};
    }
    return {};
}

} // namespace

MessageBar::MessageBar(const Theme& theme, QWidget* parent) : QFrame(parent), m_theme(theme) {
    setObjectName(QStringLiteral("messages"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(theme.px(14), theme.px(8), theme.px(8), theme.px(8));
    row->setSpacing(theme.px(10));
    m_sign = new QLabel;
    m_text = kit::label(theme, {});
    m_text->setObjectName(QStringLiteral("messages.text"));
    m_action = kit::button(theme, {});
    m_action->setObjectName(QStringLiteral("messages.action"));
    m_close = kit::iconButton(theme, QStringLiteral("window-close"), tr("Close this message"));
    row->addWidget(m_sign);
    row->addWidget(m_text, 1);
    row->addWidget(m_action);
    row->addWidget(m_close);
    m_timer = new QTimer(this);
    m_timer->setSingleShot(true);
    connect(m_timer, &QTimer::timeout, this, &QWidget::hide);
    connect(m_close, &QPushButton::clicked, this, &QWidget::hide);
    connect(m_action, &QPushButton::clicked, this, [this] {
        hide();
        if (m_act)
            m_act();
    });
    hide();
}

void MessageBar::tell(const Message& message) {
    const Look look = lookOf(message.kind);
    setProperty("kind", QLatin1String(look.kind));
    style()->polish(this);
    m_sign->setPixmap(m_theme.icon(QLatin1String(look.icon), look.ink).pixmap(m_theme.px(22), m_theme.px(22)));
    m_text->setText(message.text);
    m_action->setText(message.actionText);
    m_action->setVisible(!message.actionText.isEmpty());
    m_act = message.action;
    show();
    m_timer->stop();
    if (message.kind != MessageKind::error)
        m_timer->start(kShown_ms);
}

} // namespace chiron::desktop
