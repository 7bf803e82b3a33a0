// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/side_panel.h"

#include "desktop/training/info_view.h"
#include "desktop/widgets/kit.h"

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
    auto* words = kit::label(theme, tr("Ctrl+Page Down: read on"), TextStyle::small, "muted");
    words->setObjectName(QStringLiteral("training.side.read_on"));
    words->hide();
    connect(m_page->verticalScrollBar(), &QScrollBar::rangeChanged, words,
            [words](int, int maximum) { words->setVisible(maximum > 0); });
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(4));
    column->addWidget(m_page, 1);
    column->addWidget(words);
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
    while (given < m_info->mayGiveUp() && needed_px() > height())
        m_info->giveUp(++given);
    m_fitting = false;
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
