// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/debrief/meaning_table.h"

#include <QHeaderView>
#include <QPainter>
#include <QStyledItemDelegate>
#include <algorithm>

namespace chiron::desktop {

namespace {

constexpr int kLeast_px = 320; ///< of the first column; if there is less, the table scrolls sideways
constexpr int kPadding_px = 8;
constexpr int kLeastRow_px = 36;

class MeaningDelegate final : public QStyledItemDelegate {
public:
    MeaningDelegate(const Theme& theme, QObject* parent) : QStyledItemDelegate(parent), m_theme(theme) {}

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        QStyleOptionViewItem ground = option;
        initStyleOption(&ground, index);
        ground.text.clear();
        const QWidget* widget = option.widget;
        widget->style()->drawControl(QStyle::CE_ItemViewItem, &ground, painter, widget);
        const QRect room = option.rect.adjusted(pad(), pad(), -pad(), -pad());
        const QFont title = m_theme.font(TextStyle::body);
        painter->save();
        painter->setFont(title);
        painter->setPen(m_theme.color(Colour::text));
        painter->drawText(room, kFlags, index.data().toString());
        painter->setFont(m_theme.font(TextStyle::small));
        painter->setPen(m_theme.color(Colour::muted));
        painter->drawText(room.adjusted(0, heightOf(title, index.data().toString(), room.width()), 0, 0),
                          kFlags, meaningOf(index));
        painter->restore();
    }

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const int width = std::max(option.rect.width(), m_theme.px(kLeast_px)) - 2 * pad();
        const int height = heightOf(m_theme.font(TextStyle::body), index.data().toString(), width) +
                           heightOf(m_theme.font(TextStyle::small), meaningOf(index), width);
        return {m_theme.px(kLeast_px), std::max(height + 2 * pad(), m_theme.px(kLeastRow_px))};
    }

private:
    static constexpr int kFlags = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;

    static QString meaningOf(const QModelIndex& index) {
        return index.data(Qt::AccessibleDescriptionRole).toString();
    }
    static int heightOf(const QFont& font, const QString& text, int width) {
        return text.isEmpty()
                   ? 0
                   : QFontMetrics(font).boundingRect(QRect(0, 0, width, 10000), kFlags, text).height();
    }
    int pad() const { return m_theme.px(kPadding_px); }

    const Theme& m_theme;
};

} // namespace

MeaningTable::MeaningTable(const Theme& theme, int columns, QWidget* parent)
    : FittedTable(theme, columns, parent), m_theme(theme) {
    setItemDelegateForColumn(0, new MeaningDelegate(theme, this));
    horizontalHeader()->setSectionResizeMode(0, QHeaderView::Fixed);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void MeaningTable::hideEmptyColumns() {
    for (int column = 1; column < columnCount(); ++column) {
        bool empty = true;
        for (int row = 0; row < rowCount() && empty; ++row)
            empty = !item(row, column) ||
                    (item(row, column)->text().isEmpty() && item(row, column)->icon().isNull());
        setColumnHidden(column, empty);
    }
    fitWords();
}

void MeaningTable::fitWords() {
    horizontalHeader()->setStretchLastSection(false);
    int others = 0;
    for (int column = 1; column < columnCount(); ++column)
        others += isColumnHidden(column)
                      ? 0
                      : std::max(sizeHintForColumn(column), horizontalHeader()->sectionSizeHint(column));
    setColumnWidth(0, std::max(m_theme.px(kLeast_px), viewport()->width() - others));
    resizeRowsToContents();
    int height = horizontalHeader()->height() + m_theme.px(18); // includes the scroll bar
    for (int row = 0; row < rowCount(); ++row)
        height += rowHeight(row);
    setFixedHeight(height);
}

void MeaningTable::resizeEvent(QResizeEvent* event) {
    FittedTable::resizeEvent(event);
    fitWords();
}

void MeaningTable::showEvent(QShowEvent* event) {
    FittedTable::showEvent(event);
    fitWords();
}

} // namespace chiron::desktop
