// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/exercise_setup/choice_tile.h"

#include "desktop/widgets/kit.h"

#include <QHBoxLayout>
#include <QLabel>

namespace chiron::desktop {

ChoiceTile::ChoiceTile(const Theme& theme, const QString& title, const QString& words, const QString& icon,
                       QWidget* parent)
    : TileButton(theme, parent), m_title(title) {
    setCheckable(true);
    if (!icon.isEmpty()) {
        auto* picture = new QLabel;
        picture->setPixmap(theme.icon(icon).pixmap(theme.px(24), theme.px(24)));
        row()->addWidget(picture, 0, Qt::AlignVCenter);
    }
    auto* column = new QVBoxLayout;
    column->setSpacing(theme.px(2));
    column->addWidget(kit::label(theme, title, TextStyle::strong));
    m_words = kit::label(theme, words, TextStyle::small);
    column->addWidget(m_words);
    row()->addLayout(column, 1);
    seal();
    setWords(words);
}

void ChoiceTile::setWords(const QString& words) {
    m_words->setText(words);
    m_words->setVisible(!words.isEmpty());
    setAccessibleName(words.isEmpty() ? m_title : tr("%1. %2").arg(m_title, words));
    updateGeometry();
}

} // namespace chiron::desktop
