// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/widgets/state_panel.h"

#include "desktop/frame/background.h"
#include "desktop/widgets/kit.h"

#include <QProgressBar>
#include <QTimer>

namespace chiron::desktop {

namespace {
constexpr int kStep_ms = 100;
constexpr int kShowProgress_ms = 500; // experience.md, Rules
constexpr int kShowCancel_ms = 2000;
} // namespace

StatePanel::StatePanel(const Theme& theme, QWidget* parent) : QStackedWidget(parent), m_theme(theme) {
    buildLoading();
    m_timer = new QTimer(this);
    m_timer->setInterval(kStep_ms);
    connect(m_timer, &QTimer::timeout, this, &StatePanel::revealProgress);
}

void StatePanel::buildLoading() {
    m_loading = new QWidget;
    auto* column = new QVBoxLayout(m_loading);
    column->setSpacing(m_theme.px(12));
    column->addStretch();
    m_loadingText = kit::label(m_theme, {}, TextStyle::body, "muted");
    m_loadingText->setAlignment(Qt::AlignCenter);
    column->addWidget(m_loadingText);
    column->addStretch();
    addWidget(m_loading);
}

// Created only when needed, because most loading ends before the progress would appear.
void StatePanel::buildProgress() {
    auto* column = static_cast<QVBoxLayout*>(m_loading->layout());
    m_progress = new QProgressBar;
    m_progress->setAccessibleName(tr("Progress"));
    m_progress->setFixedWidth(m_theme.px(280));
    m_cancel = kit::button(m_theme, tr("Cancel"));
    m_cancel->setObjectName(QStringLiteral("state.cancel"));
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        if (m_token)
            m_token->cancel();
        m_cancel->setEnabled(false);
    });
    column->insertWidget(column->count() - 1, m_progress, 0, Qt::AlignHCenter);
    column->insertWidget(column->count() - 1, m_cancel, 0, Qt::AlignHCenter);
    m_cancel->hide();
}

void StatePanel::buildNote() {
    m_note = new QWidget;
    auto* column = new QVBoxLayout(m_note);
    column->setContentsMargins(m_theme.px(24), m_theme.px(12), m_theme.px(24), m_theme.px(12));
    column->setSpacing(m_theme.px(12));
    column->addStretch();
    m_noteIcon = new QLabel;
    m_noteIcon->setAlignment(Qt::AlignCenter);
    m_noteTitle = kit::label(m_theme, {}, TextStyle::title);
    m_noteTitle->setAlignment(Qt::AlignCenter);
    m_noteTitle->setObjectName(QStringLiteral("state.title"));
    m_noteText = kit::label(m_theme, {}, TextStyle::body, "muted");
    m_noteText->setAlignment(Qt::AlignCenter);
    m_noteText->setObjectName(QStringLiteral("state.text"));
    m_noteAction = kit::button(m_theme, {}, "primary");
    m_noteAction->setObjectName(QStringLiteral("state.action"));
    connect(m_noteAction, &QPushButton::clicked, this, [this] {
        const auto action = m_action; // a copy, because the action may show another state and replace it
        if (action)
            action();
    });
    column->addWidget(m_noteIcon);
    column->addWidget(m_noteTitle);
    column->addWidget(m_noteText);
    column->addWidget(m_noteAction, 0, Qt::AlignHCenter);
    column->addStretch();
    addWidget(m_note);
}

void StatePanel::setContent(QWidget* content) {
    m_content = content;
    addWidget(content);
}

void StatePanel::showLoading(const QString& what, std::shared_ptr<WorkToken> token) {
    m_state = State::loading;
    m_token = std::move(token);
    m_what = what;
    m_loadingText->setText(what);
    if (m_progress) {
        m_progress->hide();
        m_cancel->hide();
        m_cancel->setEnabled(true);
    }
    m_elapsed_ms = 0;
    m_timer->start();
    setCurrentWidget(m_loading);
}

void StatePanel::revealProgress() {
    m_elapsed_ms += kStep_ms;
    if (m_elapsed_ms < kShowProgress_ms)
        return;
    if (!m_progress)
        buildProgress();
    m_progress->show();
    if (m_elapsed_ms >= kShowCancel_ms)
        m_cancel->setVisible(m_token != nullptr);
    if (const QString doing = m_token ? m_token->doing() : QString(); !doing.isEmpty())
        m_loadingText->setText(m_what + QLatin1Char('\n') + doing);
    m_progress->setRange(0, m_token ? m_token->of() : 0);
    m_progress->setValue(m_token ? m_token->done() : 0);
}

void StatePanel::showContent() {
    m_state = State::content;
    m_timer->stop();
    m_token.reset();
    setCurrentWidget(m_content);
}

void StatePanel::showNote(const QString& icon, Colour ink, const QString& title, const QString& text,
                          const QString& actionText, std::function<void()> action) {
    m_timer->stop();
    m_token.reset();
    if (!m_note)
        buildNote();
    m_noteIcon->setPixmap(m_theme.icon(icon, ink).pixmap(m_theme.px(44), m_theme.px(44)));
    m_noteTitle->setText(title);
    m_noteText->setText(text);
    m_noteAction->setText(actionText);
    m_noteAction->setVisible(!actionText.isEmpty());
    m_action = std::move(action);
    setCurrentWidget(m_note);
}

void StatePanel::showEmpty(const QString& title, const QString& text, const QString& actionText,
                           std::function<void()> action) {
    m_state = State::empty;
    showNote(QStringLiteral("view-list-details"), Colour::muted, title, text, actionText, std::move(action));
}

void StatePanel::showError(const QString& title, const core::Error& error, std::function<void()> again,
                           Tried tried) {
    m_state = State::error;
    const QString actionText = again ? tr("Try again") : QString();
    showNote(QStringLiteral("dialog-error"), Colour::bad, title, inWords(error, tried), actionText,
             std::move(again));
}

} // namespace chiron::desktop
