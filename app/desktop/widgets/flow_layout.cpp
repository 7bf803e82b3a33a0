// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/widgets/flow_layout.h"

#include <QWidget>
#include <algorithm>
#include <utility>

namespace chiron::desktop {

FlowLayout::FlowLayout(int spacing_px, QWidget* parent) : QLayout(parent) {
    setSpacing(spacing_px);
    setContentsMargins(0, 0, 0, 0);
}

FlowLayout::~FlowLayout() = default;

void FlowLayout::addItem(QLayoutItem* item) {
    m_items.emplace_back(item);
}

QLayoutItem* FlowLayout::itemAt(int index) const {
    return index >= 0 && index < count() ? m_items[static_cast<std::size_t>(index)].get() : nullptr;
}

QLayoutItem* FlowLayout::takeAt(int index) {
    if (index < 0 || index >= count())
        return nullptr;
    QLayoutItem* item = m_items[static_cast<std::size_t>(index)].release();
    m_items.erase(m_items.begin() + index);
    return item;
}

QSize FlowLayout::minimumSize() const {
    QSize size;
    for (const auto& item : m_items)
        size = size.expandedTo(item->minimumSize());
    return size;
}

void FlowLayout::setGeometry(const QRect& area) {
    QLayout::setGeometry(area);
    arrange(area, true);
}

int FlowLayout::arrange(const QRect& area, bool place) const {
    std::vector<std::pair<QLayoutItem*, QRect>> line; // items of one line, aligned at their vertical centres
    int x = area.x();
    int y = area.y();
    int height = 0;
    const auto endLine = [&] {
        for (const auto& [item, at] : line)
            if (place)
                item->setGeometry(at.translated(0, (height - at.height()) / 2));
        line.clear();
    };
    for (const auto& item : m_items) {
        if (item->isEmpty())
            continue; // hidden items take no space
        const QSize wanted(
            std::min(item->sizeHint().width(), std::max(area.width(), item->minimumSize().width())),
            item->sizeHint().height());
        if (x > area.x() && x + wanted.width() > area.x() + area.width()) {
            endLine();
            x = area.x();
            y += height + spacing();
            height = 0;
        }
        line.emplace_back(item.get(), QRect(QPoint(x, y), wanted));
        x += wanted.width() + spacing();
        height = std::max(height, wanted.height());
    }
    endLine();
    return y + height - area.y();
}

} // namespace chiron::desktop
