// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/storage/task_strip.h"

#include "desktop/frame/background.h"
#include "desktop/widgets/kit.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QTimer>

namespace chiron::desktop {

TaskStrip::TaskStrip(const Theme& theme, QWidget* parent) : QFrame(parent) {
    constexpr int kLook_ms = 100;
    setProperty("kind", QStringLiteral("info"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(theme.px(14), theme.px(8), theme.px(14), theme.px(8));
    row->setSpacing(theme.px(12));
    m_text = kit::label(theme, {}, TextStyle::strong);
    m_text->setObjectName(QStringLiteral("task.text"));
    m_bar = new QProgressBar;
    m_bar->setAccessibleName(tr("Progress"));
    m_bar->setMinimumWidth(theme.px(160));
    m_cancel = kit::button(theme, tr("Cancel"));
    m_cancel->setObjectName(QStringLiteral("task.cancel"));
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        if (m_token)
            m_token->cancel();
        m_cancel->setEnabled(false);
        m_text->setText(tr("Stopping …"));
    });
    row->addWidget(m_text, 1);
    row->addWidget(m_bar, 1);
    row->addWidget(m_cancel);
    m_timer = new QTimer(this);
    m_timer->setInterval(kLook_ms);
    connect(m_timer, &QTimer::timeout, this, &TaskStrip::update);
    hide();
}

void TaskStrip::start(const QString& what, std::shared_ptr<WorkToken> token) {
    m_running = true;
    m_token = std::move(token);
    m_text->setText(what);
    m_cancel->setVisible(m_token != nullptr);
    m_cancel->setEnabled(true);
    update();
    m_timer->start();
    show();
}

void TaskStrip::stop() {
    m_running = false;
    m_timer->stop();
    m_token.reset();
    hide();
}

void TaskStrip::update() {
    m_bar->setRange(0, m_token ? m_token->of() : 0);
    m_bar->setValue(m_token ? m_token->done() : 0);
}

} // namespace chiron::desktop
