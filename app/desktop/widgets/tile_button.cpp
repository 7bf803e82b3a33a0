// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/widgets/tile_button.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>

namespace chiron::desktop {

TileButton::TileButton(const Theme& theme, QWidget* parent)
    : QPushButton(parent), m_row(new QHBoxLayout(this)) {
    setProperty("kind", QStringLiteral("tile"));
    setAutoDefault(false);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    m_row->setContentsMargins(theme.px(14), theme.px(8), theme.px(14), theme.px(8));
    m_row->setSpacing(theme.px(10));
}

void TileButton::seal() {
    for (QLabel* label : findChildren<QLabel*>())
        label->setAttribute(Qt::WA_TransparentForMouseEvents);
}

QSize TileButton::sizeHint() const {
    return m_row->totalSizeHint();
}

QSize TileButton::minimumSizeHint() const {
    return m_row->totalMinimumSize();
}

int TileButton::heightForWidth(int width) const {
    return m_row->totalHeightForWidth(width);
}

void TileButton::resizeEvent(QResizeEvent* event) {
    QPushButton::resizeEvent(event);
    keepWords();
}

bool TileButton::event(QEvent* event) {
    const bool done = QPushButton::event(event);
    if (event->type() == QEvent::LayoutRequest)
        keepWords(); // text added later needs space as well, although the width is unchanged
    return done;
}

// A scroll area asks only for the minimum size; without this it would squeeze the second line of text.
void TileButton::keepWords() {
    setMinimumHeight(heightForWidth(width()));
    if (m_row->geometry() != rect()) // the text was still laid out for a smaller height
        m_row->setGeometry(rect());
}

} // namespace chiron::desktop
