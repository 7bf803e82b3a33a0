// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/widgets/page_footer.h"

#include "desktop/widgets/kit.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace chiron::desktop {

PageFooter::PageFooter(const Theme& theme, int maximumWidth_px, QWidget* parent)
    : QWidget(parent), m_room(new QVBoxLayout) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(kit::rule());
    auto* inner = new QWidget;
    inner->setMaximumWidth(theme.px(maximumWidth_px));
    inner->setLayout(m_room);
    m_room->setContentsMargins(0, 0, 0, 0);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(theme.px(24), theme.px(12), theme.px(24), theme.px(12));
    row->addStretch(1);
    row->addWidget(inner, 1000);
    row->addStretch(1);
    column->addLayout(row);
    hide();
}

void PageFooter::hold(QWidget* controls) {
    if (m_held) {
        m_room->removeWidget(m_held);
        m_held->hide();
        m_held->deleteLater(); // the call may come from one of them
    }
    m_held = controls;
    if (controls) {
        m_room->addWidget(controls);
        controls->show();
    }
    setVisible(controls != nullptr);
}

} // namespace chiron::desktop
