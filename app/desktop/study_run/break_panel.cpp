// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_run/break_panel.h"

#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"

#include <QKeyEvent>
#include <QProgressBar>
#include <QScrollBar>
#include <cmath>

namespace chiron::desktop {

BreakPanel::BreakPanel(const Theme& theme, QWidget* parent) : QWidget(parent) {
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    m_page = new ScrollPage(theme, 760);
    all->addWidget(m_page);
    QVBoxLayout* column = m_page->column();
    column->setSpacing(theme.px(16));
    column->addStretch(1);
    m_title = kit::label(theme, {}, TextStyle::display);
    m_title->setObjectName(QStringLiteral("break.title"));
    m_title->setAlignment(Qt::AlignHCenter);
    m_text = kit::label(theme, {}, TextStyle::title);
    m_text->setObjectName(QStringLiteral("break.text"));
    m_text->setAlignment(Qt::AlignHCenter);
    m_bar = new QProgressBar;
    m_bar->setAccessibleName(tr("Break time"));
    m_bar->setTextVisible(false);
    m_bar->hide();
    m_button = kit::button(theme, {}, "primary");
    m_button->setObjectName(QStringLiteral("break.button"));
    m_button->setFont(theme.font(TextStyle::title));
    column->addWidget(m_title);
    column->addWidget(m_text);
    column->addWidget(m_bar);
    column->addWidget(m_button, 0, Qt::AlignHCenter);
    m_more = kit::button(theme, {}, "quiet");
    m_more->setObjectName(QStringLiteral("break.more"));
    m_more->hide();
    column->addWidget(m_more, 0, Qt::AlignHCenter);
    connect(m_more, &QPushButton::clicked, this, &BreakPanel::moreAsked);
    column->addStretch(2);
    auto* more = kit::label(theme, tr("Enter or Space: read on"), TextStyle::small, "muted");
    more->setObjectName(QStringLiteral("break.read_on"));
    more->setAlignment(Qt::AlignHCenter);
    more->hide();
    all->addWidget(more);
    const auto showMore = [this, more] {
        const QScrollBar& bar = *m_page->verticalScrollBar();
        more->setVisible(bar.value() < bar.maximum());
        if (more->isVisible() && m_button->hasFocus())
            setFocus(Qt::OtherFocusReason); // Enter reads on, and presses nothing that is not seen
    };
    connect(m_page->verticalScrollBar(), &QScrollBar::rangeChanged, more, showMore);
    connect(m_page->verticalScrollBar(), &QScrollBar::valueChanged, more, showMore);
    connect(m_button, &QPushButton::clicked, this, &BreakPanel::acted);
}

void BreakPanel::say(const QString& title, const QString& text, const QString& action) {
    if (m_text->text() != text)
        m_page->verticalScrollBar()->setValue(0);
    m_title->setText(title);
    m_text->setText(text);
    m_text->setVisible(!text.isEmpty());
    m_button->setText(action);
    m_button->setVisible(!action.isEmpty());
    offer({});
}

void BreakPanel::offer(const QString& more) {
    m_more->setText(more);
    m_more->setVisible(!more.isEmpty());
}

void BreakPanel::countDown(double left_s, double of_s) {
    m_bar->setVisible(left_s > 0.0 && of_s > 0.0);
    m_button->setEnabled(left_s <= 0.0);
    if (left_s > 0.0 && of_s > 0.0) {
        m_bar->setRange(0, static_cast<int>(std::lround(10.0 * of_s)));
        m_bar->setValue(static_cast<int>(std::lround(10.0 * (of_s - left_s))));
    }
}

/// Enter would press a focused button, also below the end of what is visible.
void BreakPanel::focusButton() {
    const QScrollBar& bar = *m_page->verticalScrollBar();
    if (bar.value() < bar.maximum())
        setFocus(Qt::OtherFocusReason);
    else if (m_button->isVisibleTo(this))
        m_button->setFocus(Qt::OtherFocusReason);
}

bool BreakPanel::readOn() {
    QScrollBar& bar = *m_page->verticalScrollBar();
    if (bar.value() >= bar.maximum())
        return false;
    bar.triggerAction(QAbstractSlider::SliderPageStepAdd);
    focusButton();
    return true;
}

void BreakPanel::keyPressEvent(QKeyEvent* event) {
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (enter && !m_more->hasFocus() && readOn())
        return;
    if (enter && m_button->isVisibleTo(this) && m_button->isEnabled() && !m_more->hasFocus())
        m_button->click();
    else
        QWidget::keyPressEvent(event);
}

} // namespace chiron::desktop
