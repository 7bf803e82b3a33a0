// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/role_chips.h"

#include "desktop/people/people_model.h"

#include <QApplication>
#include <QPainter>
#include <algorithm>

namespace chiron::desktop {

namespace {
constexpr double kPadding = 8;
constexpr double kGap = 6;
constexpr double kChipHeight = 22;
} // namespace

int RoleChips::chipWidth(const QString& text) const {
    return QFontMetrics(m_theme.font(TextStyle::small)).horizontalAdvance(text) + 2 * m_theme.px(kPadding);
}

QSize RoleChips::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
    int width = 2 * m_theme.px(kPadding);
    for (const QString& chip : index.data(PeopleModel::kChips).toStringList())
        width += chipWidth(chip) + m_theme.px(kGap);
    return {width,
            std::max(QStyledItemDelegate::sizeHint(option, index).height(), m_theme.px(kChipHeight + kGap))};
}

void RoleChips::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    QStyleOptionViewItem background(option);
    initStyleOption(&background, index);
    background.text.clear();
    QApplication::style()->drawControl(QStyle::CE_ItemViewItem, &background, painter, option.widget);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setFont(m_theme.font(TextStyle::small));
    const int height = m_theme.px(kChipHeight);
    int x = option.rect.x() + m_theme.px(kPadding);
    for (const QString& chip : index.data(PeopleModel::kChips).toStringList()) {
        const QRect rect(x, option.rect.center().y() - height / 2, chipWidth(chip), height);
        painter->setPen(m_theme.color(Colour::accent));
        painter->setBrush(m_theme.color(Colour::surface));
        painter->drawRoundedRect(QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5), height / 2.0, height / 2.0);
        painter->setPen(m_theme.color(Colour::text));
        painter->drawText(rect, Qt::AlignCenter, chip);
        x += rect.width() + m_theme.px(kGap);
    }
    painter->restore();
}

} // namespace chiron::desktop
