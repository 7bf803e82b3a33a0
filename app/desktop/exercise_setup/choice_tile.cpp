// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/exercise_setup/choice_tile.h"

#include "desktop/widgets/kit.h"

#include <QHBoxLayout>
#include <QLabel>

namespace chiron::desktop {

ChoiceTile::ChoiceTile(const Theme& theme, const QString& title, const QString& words, const QString& icon, QWidget* parent)
    : QPushButton(parent), m_title(title) {
    setProperty("kind", QStringLiteral("tile"));
    setCheckable(true);
    setAutoDefault(false);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(theme.px(14), theme.px(10), theme.px(14), theme.px(10));
    row->setSpacing(theme.px(12));
    if (!icon.isEmpty()) {
        auto* picture = new QLabel;
        picture->setPixmap(theme.icon(icon).pixmap(theme.px(24), theme.px(24)));
        row->addWidget(picture, 0, Qt::AlignVCenter);
    }
    auto* column = new QVBoxLayout;
    column->setSpacing(theme.px(2));
    column->addWidget(kit::label(theme, title, TextStyle::strong));
    m_words = kit::label(theme, words, TextStyle::small);
    column->addWidget(m_words);
    row->addLayout(column, 1);
    for (QLabel* label : findChildren<QLabel*>())
        label->setAttribute(Qt::WA_TransparentForMouseEvents); // the whole tile is the button
    setWords(words);
}

void ChoiceTile::setWords(const QString& words) {
    m_words->setText(words);
    m_words->setVisible(!words.isEmpty());
    setAccessibleName(words.isEmpty() ? m_title : tr("%1. %2").arg(m_title, words));
    updateGeometry();
}

QSize ChoiceTile::sizeHint() const { return layout()->sizeHint(); }
QSize ChoiceTile::minimumSizeHint() const { return layout()->minimumSize(); }
int ChoiceTile::heightForWidth(int width) const { return layout()->heightForWidth(width); }

} // namespace chiron::desktop
