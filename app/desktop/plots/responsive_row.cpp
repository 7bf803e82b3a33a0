// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/plots/responsive_row.h"

#include <QResizeEvent>

namespace chiron::desktop {

ResponsiveRow::ResponsiveRow(int turnsAt_px, int spacing_px, QWidget* parent)
    : QWidget(parent), m_layout(new QBoxLayout(QBoxLayout::TopToBottom, this)), m_turnsAt_px(turnsAt_px) {
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setSpacing(spacing_px);
}

void ResponsiveRow::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const bool wide = event->size().width() >= m_turnsAt_px;
    const auto direction = wide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom;
    if (m_layout->direction() != direction)
        m_layout->setDirection(direction);
}

} // namespace chiron::desktop
