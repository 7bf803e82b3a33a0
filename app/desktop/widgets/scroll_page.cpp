// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/widgets/scroll_page.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QVBoxLayout>

namespace chiron::desktop {

ScrollPage::ScrollPage(const Theme& theme, int maximumWidth_px, QWidget* parent) : QScrollArea(parent) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    auto* page = new QWidget;
    page->setProperty("kind", QStringLiteral("page"));
    auto* row = new QHBoxLayout(page);
    const int margin = theme.px(24);
    row->setContentsMargins(margin, margin, margin, margin);
    auto* inner = new QWidget;
    if (maximumWidth_px > 0)
        inner->setMaximumWidth(theme.px(maximumWidth_px));
    m_column = new QVBoxLayout(inner);
    m_column->setContentsMargins(0, 0, 0, 0);
    m_column->setSpacing(theme.px(16));
    row->addStretch(1);
    row->addWidget(inner, 1000);
    row->addStretch(1);
    setWidget(page);
}

bool ScrollPage::focusNextPrevChild(bool next) {
    const bool moved = QScrollArea::focusNextPrevChild(next);
    if (QWidget* focused = QApplication::focusWidget(); moved && focused && isAncestorOf(focused))
        ensureWidgetVisible(focused);
    return moved;
}

} // namespace chiron::desktop
