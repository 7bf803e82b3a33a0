// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/accounts/notice_area.h"

#include "desktop/widgets/kit.h"

#include <QAccessible>

namespace chiron::desktop {

NoticeArea::NoticeArea(const Theme& theme, QWidget* parent) : QWidget(parent), m_theme(theme) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    hide();
}

void NoticeArea::say(const char* kind, const QString& text) {
    m_text = text;
    delete m_notice;
    m_notice = nullptr;
    setAccessibleName(text);
    setVisible(!text.isEmpty());
    if (text.isEmpty())
        return;
    m_notice = kit::notice(m_theme, kind, text);
    layout()->addWidget(m_notice);
    QAccessibleEvent event(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&event);
}

} // namespace chiron::desktop
