// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/widgets/flow_layout.h"

#include <QWidget>
#include <algorithm>

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
    int x = area.x();
    int y = area.y();
    int line = 0;
    for (const auto& item : m_items) {
        if (item->isEmpty())
            continue; // hidden
        const QSize wanted(std::min(item->sizeHint().width(), std::max(area.width(), item->minimumSize().width())),
                           item->sizeHint().height());
        if (x > area.x() && x + wanted.width() > area.x() + area.width()) {
            x = area.x();
            y += line + spacing();
            line = 0;
        }
        if (place)
            item->setGeometry({x, y, wanted.width(), wanted.height()});
        x += wanted.width() + spacing();
        line = std::max(line, wanted.height());
    }
    return y + line - area.y();
}

} // namespace chiron::desktop
