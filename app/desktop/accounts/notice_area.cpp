// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/accounts/notice_area.h"

#include "desktop/widgets/kit.h"

#include <QAccessible>
#include <QFontMetrics>
#include <QVBoxLayout>
#include <algorithm>

namespace chiron::desktop {

namespace {
constexpr int kLines = 2;
constexpr double kFrame_px = 24; // of kit::notice, above and below its text
} // namespace

NoticeArea::NoticeArea(const Theme& theme, Room room, QWidget* parent)
    : QWidget(parent), m_theme(theme), m_room(room) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    if (room == Room::kept) {
        QSizePolicy keeps = sizePolicy();
        keeps.setRetainSizeWhenHidden(true);
        setSizePolicy(keeps);
        setMinimumHeight(kLines * QFontMetrics(theme.font(TextStyle::body)).lineSpacing() +
                         theme.px(kFrame_px));
        column->setAlignment(Qt::AlignTop);
    }
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
    if (m_room == Room::kept && width() > 0)
        // A longer notice keeps its room as well.
        setMinimumHeight(std::max(minimumHeight(), m_notice->heightForWidth(width())));
    QAccessibleEvent event(this, QAccessible::Alert);
    QAccessible::updateAccessibility(&event);
}

} // namespace chiron::desktop
