// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/signed_bar.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {
constexpr double kReach = 1.25; // multiple of the limit, so that a value beyond it is visibly beyond
} // namespace

SignedBar::SignedBar(const Theme& theme, const QLocale& locale, Quantity quantity, bool bar, bool number,
                     QWidget* parent)
    : QWidget(parent), m_theme(theme), m_locale(locale), m_quantity(std::move(quantity)), m_bar(bar),
      m_number(number) {
    setAccessibleName(m_quantity.name);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize SignedBar::sizeHint() const {
    const QFontMetrics metrics(m_theme.font(TextStyle::label));
    const int words =
        metrics.horizontalAdvance(m_quantity.sign) +
        (m_number
             ? metrics.horizontalAdvance(m_locale.toString(-m_quantity.limit, 'f', m_quantity.decimals)) +
                   m_theme.px(6)
             : 0);
    return {std::max(words, m_theme.px(62)), metrics.height() + (m_bar ? m_theme.px(16) : 0)};
}

void SignedBar::setValue(double value) {
    if (!std::isfinite(value) || value == m_value)
        return;
    const bool wasOver = isOver();
    m_value = value;
    if (wasOver != isOver())
        speak();
    update();
}

QString SignedBar::numberText() const {
    const double step = std::pow(10.0, m_quantity.decimals);
    // Adding 0 avoids a minus sign before 0.0.
    return m_locale.toString(std::round(m_value * step) / step + 0.0, 'f', m_quantity.decimals);
}

void SignedBar::speak() {
    QString words;
    if (m_number)
        words = isOver() ? tr("%1 %2, over the limit").arg(numberText(), m_quantity.unit)
                         : tr("%1 %2").arg(numberText(), m_quantity.unit);
    else if (isOver())
        words = tr("over the limit");
    if (words != accessibleDescription())
        setAccessibleDescription(words);
}

void SignedBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setFont(m_theme.font(TextStyle::label));
    const QRect head(0, 0, width(), painter.fontMetrics().height());
    painter.setPen(m_theme.color(Colour::muted));
    painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter, m_quantity.sign);
    if (m_number) {
        painter.setPen(m_theme.color(isOver() ? Colour::bad : Colour::text));
        painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter, numberText());
    }
    if (m_bar)
        paintBar(painter, head.height() + m_theme.px(3));
}

void SignedBar::paintBar(QPainter& painter, int top) const {
    const QRect track(0, top, width() - 1, m_theme.px(10));
    painter.setPen(m_theme.color(Colour::borderStrong));
    painter.setBrush(m_theme.color(Colour::raised));
    painter.drawRect(track);
    const int middle = track.left() + track.width() / 2;
    const double half = track.width() / 2 - 1;
    const int reach = qRound(std::clamp(m_value / (m_quantity.limit * kReach), -1.0, 1.0) * half);
    const QRect filled(std::min(middle, middle + reach), track.top() + 1, std::abs(reach),
                       track.height() - 1);
    painter.fillRect(filled, m_theme.color(isOver() ? Colour::bad : Colour::seriesA));
    if (isOver()) // not shown by colour alone
        painter.fillRect(filled, QBrush(m_theme.color(Colour::surface), Qt::BDiagPattern));
    painter.setPen(QPen(m_theme.color(Colour::borderStrong), m_theme.px(1)));
    painter.drawLine(middle, track.top(), middle, track.bottom());
    painter.setPen(QPen(m_theme.color(Colour::text), m_theme.px(2)));
    for (const double side : {-1.0, 1.0}) {
        const int x = middle + qRound(side * half / kReach);
        painter.drawLine(x, track.top() - m_theme.px(1), x, track.bottom() + m_theme.px(1));
    }
}

} // namespace chiron::desktop
