// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/message_bar.h"

#include "desktop/widgets/kit.h"

#include <QCursor>
#include <QEvent>
#include <QHBoxLayout>
#include <QStyle>
#include <QTimer>
#include <algorithm>

namespace chiron::desktop {

namespace {

constexpr int kShown_ms = 8000; // long enough to read two lines and reach for Undo
constexpr double kWidth_px = 760;
constexpr double kMargin_px = 12;

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
    if (parent)
        parent->installEventFilter(this);
}

bool MessageBar::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && watched == parent() && isVisible())
        settle();
    return QFrame::eventFilter(watched, event);
}

/// Its place in the parent, in the middle at the bottom or at the top.
void MessageBar::settle() {
    const QWidget* over = parentWidget();
    if (!over)
        return;
    const int margin = m_theme.px(kMargin_px);
    const int width = std::min(m_theme.px(kWidth_px), over->width() - 2 * margin);
    const int height = layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width) : sizeHint().height();
    setGeometry((over->width() - width) / 2, m_atTop ? margin : over->height() - height - margin, width, height);
}

/// Over everything that is there, and never between the pointer and what it points at.
void MessageBar::rise() {
    const QWidget* over = parentWidget();
    if (!over)
        return;
    m_atTop = false;
    settle();
    const QPoint pointer = over->mapFromGlobal(QCursor::pos());
    m_atTop = geometry().adjusted(0, -m_theme.px(kMargin_px), 0, 0).contains(pointer);
    settle();
    const QList<QWidget*> others = over->findChildren<QWidget*>();
    if (std::any_of(others.begin(), others.end(), [this](const QWidget* other) { return other != this && other->testAttribute(Qt::WA_NativeWindow); })) {
        setAttribute(Qt::WA_DontCreateNativeAncestors);
        setAttribute(Qt::WA_NativeWindow); // else the window of a 3D scene would cover it
    }
    raise();
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
    rise();
    show();
    settle(); // styled now, its height is known
    m_timer->stop();
    if (message.kind != MessageKind::error)
        m_timer->start(kShown_ms);
}

} // namespace chiron::desktop
