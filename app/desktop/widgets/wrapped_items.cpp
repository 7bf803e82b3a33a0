// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/widgets/wrapped_items.h"

#include <QListView>
#include <QStyledItemDelegate>
#include <algorithm>

namespace chiron::desktop {

namespace {

/// Of a QListView::item in the style sheet: its padding on both sides, and the border of the chosen one.
constexpr double kSides_px = 2 * 8 + 3;

/// Qt's style sheets wrap an item's text for its height as if it had no padding, so a text that just fits
/// without padding is shortened when it is drawn.
class WrappedItem final : public QStyledItemDelegate {
public:
    WrappedItem(const Theme& theme, QObject* parent)
        : QStyledItemDelegate(parent), m_sides_px(theme.px(kSides_px)) {}

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        QStyleOptionViewItem narrower(option);
        narrower.rect.setWidth(std::max(0, option.rect.width() - m_sides_px));
        return QStyledItemDelegate::sizeHint(narrower, index);
    }

private:
    int m_sides_px;
};

} // namespace

void wrapItems(QListView& list, const Theme& theme) {
    list.setItemDelegate(new WrappedItem(theme, &list));
    list.setWordWrap(true);
    list.setTextElideMode(Qt::ElideNone);
    list.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list.setResizeMode(QListView::Adjust); // lays out again when the width changes
}

} // namespace chiron::desktop
