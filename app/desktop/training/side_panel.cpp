// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/side_panel.h"

#include "desktop/training/info_view.h"
#include "desktop/widgets/kit.h"

#include <QEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

namespace chiron::desktop {

SidePanel::SidePanel(const Theme& theme, QWidget* parent) : QWidget(parent), m_page(new QScrollArea) {
    m_page->setObjectName(QStringLiteral("training.side"));
    m_page->setWidgetResizable(true);
    m_page->setFrameShape(QFrame::NoFrame);
    m_page->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_page->setFocusPolicy(Qt::NoFocus); // nothing in it can be changed
    auto* inner = new QWidget;
    inner->setProperty("kind", QStringLiteral("page"));
    m_column = new QVBoxLayout(inner);
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(theme.px(10));
    m_page->setWidget(inner);
    inner->installEventFilter(this); // its words change while it is shown
    auto* words = kit::label(theme, tr("Ctrl+Page Down: read on"), TextStyle::small, "muted");
    words->setObjectName(QStringLiteral("training.side.read_on"));
    QSizePolicy keepsRoom =
        words->sizePolicy(); // or showing it would change what decides whether it is shown
    keepsRoom.setRetainSizeWhenHidden(true);
    words->setSizePolicy(keepsRoom);
    words->hide();
    connect(m_page->verticalScrollBar(), &QScrollBar::rangeChanged, words,
            [words](int, int maximum) { words->setVisible(maximum > 0); });
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(4));
    column->addWidget(m_page, 1);
    column->addWidget(words);
    m_below_px = words->sizeHint().height() + column->spacing();
}

void SidePanel::addInfo(InfoView* info) {
    m_info = info;
    m_column->addWidget(info, 1);
}

int SidePanel::needed_px() const {
    return m_column->hasHeightForWidth() ? m_column->totalHeightForWidth(width())
                                         : m_column->totalSizeHint().height();
}

void SidePanel::fit() {
    if (!m_info || m_fitting)
        return;
    m_fitting = true; // showing a part lays out everything around it, and may resize this panel
    int given = 0;
    m_info->giveUp(given);
    while (given < m_info->mayGiveUp() && needed_px() > height() - m_below_px)
        m_info->giveUp(++given);
    m_fitting = false;
    keepHeight();
}

/// Words are never squeezed: where they do not fit, the page scrolls.
void SidePanel::keepHeight() {
    const int needed = m_column->hasHeightForWidth()
                           ? m_column->totalHeightForWidth(m_page->viewport()->width())
                           : m_column->totalSizeHint().height();
    m_page->widget()->setMinimumHeight(needed > height() - m_below_px ? needed : 0);
}

bool SidePanel::eventFilter(QObject* watched, QEvent* event) {
    const bool handled = QWidget::eventFilter(watched, event);
    if (event->type() == QEvent::LayoutRequest && !m_fitting)
        keepHeight();
    return handled;
}

void SidePanel::readOn(bool down) {
    m_page->verticalScrollBar()->triggerAction(down ? QAbstractSlider::SliderPageStepAdd
                                                    : QAbstractSlider::SliderPageStepSub);
}

void SidePanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fit();
}

} // namespace chiron::desktop
