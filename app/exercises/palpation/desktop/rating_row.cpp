// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/rating_row.h"

#include "desktop/widgets/kit.h"

#include <QHBoxLayout>
#include <algorithm>

namespace chiron::desktop {

RatingRow::RatingRow(const Theme& theme, const QString& name, Word word, QWidget* parent)
    : QWidget(parent), m_name(name), m_word(word), m_title(kit::label(theme, {}, TextStyle::label)),
      m_keys(kit::line(theme, tr("keys 1 to 5"), TextStyle::small, "accent")) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(3));
    auto* head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(m_keys, 0, Qt::AlignTop);
    column->addLayout(head);
    auto* row = new QHBoxLayout;
    row->setSpacing(theme.px(4));
    for (int rating = 1; rating <= 5; ++rating) {
        auto* button = kit::button(theme, QString::number(rating));
        button->setObjectName(QString::number(rating));
        button->setCheckable(true);
        button->setAccessibleName(tr("%1: %2, %3 of 5").arg(name, word(rating)).arg(rating));
        button->setToolTip(word(rating));
        button->setMinimumWidth(theme.px(24));
        connect(button, &QPushButton::clicked, this, [this, rating] {
            const int before = m_rating;
            // The click has already checked the button; only the rating that the session confirms counts.
            m_rating = -1;
            setRating(before);
            emit rated(rating);
        });
        m_buttons[static_cast<std::size_t>(rating - 1)] = button;
        row->addWidget(button, 1);
    }
    column->addLayout(row);
    setRating(0);
    setKeysHere(false);
}

void RatingRow::setRating(int rating) {
    if (rating == m_rating)
        return;
    m_rating = rating;
    for (std::size_t i = 0; i < m_buttons.size(); ++i)
        m_buttons[i]->setChecked(rating == static_cast<int>(i) + 1);
    m_title->setText(words());
    setAccessibleName(words());
}

void RatingRow::setKeysHere(bool here) {
    m_keys->setVisible(here);
}

QString RatingRow::words() const {
    return tr("%1: %2").arg(m_name, m_word(std::max(m_rating, 0)));
}

} // namespace chiron::desktop
