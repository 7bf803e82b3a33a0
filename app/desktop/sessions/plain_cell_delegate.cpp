// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/sessions/plain_cell_delegate.h"

#include <QPainter>

namespace chiron::desktop {

namespace {

void drawLine(QPainter& painter, const QRect& room, Qt::Alignment alignment, const QString& text) {
    const QFontMetrics metrics = painter.fontMetrics();
    const bool fits = metrics.horizontalAdvance(text) <= room.width();
    painter.drawText(room, static_cast<int>(alignment) | Qt::TextSingleLine,
                     fits ? text : metrics.elidedText(text, Qt::ElideRight, room.width()));
}

/// Both lines together stand in the middle of the cell.
void drawTwoLines(QPainter& painter, const QRect& room, Qt::Alignment alignment, const QString& first,
                  const QString& second, const Theme& theme) {
    const QFont below = theme.font(TextStyle::small);
    const int firstHeight = painter.fontMetrics().height(),
              height = firstHeight + QFontMetrics(below).height();
    const Qt::Alignment across = alignment & Qt::AlignHorizontal_Mask;
    const QRect upper(room.left(), room.center().y() - height / 2, room.width(), firstHeight);
    drawLine(painter, upper, across | Qt::AlignVCenter, first);
    painter.setFont(below);
    painter.setPen(theme.color(Colour::muted));
    drawLine(painter, QRect(upper.left(), upper.bottom() + 1, upper.width(), height - firstHeight),
             across | Qt::AlignVCenter, second);
}

} // namespace

void PlainCellDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const {
    if (option.state & QStyle::State_Selected)
        painter->fillRect(option.rect, m_theme.color(Colour::accentSoft));
    QRect room = option.rect.adjusted(m_theme.px(6), 0, -m_theme.px(6), 0);
    const QVariant picture = index.data(Qt::DecorationRole);
    if (picture.isValid()) {
        QRect place(QPoint(room.left(), 0), option.decorationSize);
        place.moveCenter(QPoint(place.center().x(), room.center().y()));
        picture.value<QIcon>().paint(painter, place);
        room.setLeft(place.right() + m_theme.px(8));
    }
    const QVariant ink = index.data(Qt::ForegroundRole);
    painter->setPen(ink.isValid() ? ink.value<QColor>() : m_theme.color(Colour::text));
    painter->setFont(option.font);
    auto alignment = index.data(Qt::TextAlignmentRole).value<Qt::Alignment>();
    if (!(alignment & Qt::AlignVertical_Mask))
        alignment |= Qt::AlignVCenter;
    const QString text = index.data().toString(), second = index.data(kSecondLine).toString();
    if (second.isEmpty())
        drawLine(*painter, room, alignment, text);
    else
        drawTwoLines(*painter, room, alignment, text, second, m_theme);
    if (option.state & QStyle::State_HasFocus) {
        painter->setPen(QPen(m_theme.color(Colour::focus), m_theme.px(2)));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(option.rect.adjusted(1, 1, -2, -2));
    }
}

} // namespace chiron::desktop
