// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/target_bar.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

TargetBar::TargetBar(const Theme& theme, const QLocale& locale, Quantity quantity, bool numbers,
                     QWidget* parent)
    : QWidget(parent), m_theme(theme), m_locale(locale), m_quantity(std::move(quantity)),
      m_head(theme, m_quantity.name), m_numbers(numbers) {
    setAccessibleName(m_quantity.name);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize TargetBar::sizeHint() const {
    return {m_theme.px(200), m_theme.px(42) + m_head.extra_px()};
}

void TargetBar::setBand(double low, double high) {
    if (low == m_low && high == m_high)
        return;
    m_low = low;
    m_high = high;
    fit();
    say();
    update();
}

void TargetBar::setLimit(double limit) {
    if (limit == m_limit)
        return;
    m_limit = limit;
    fit();
    say();
    update();
}

void TargetBar::setValue(double value) {
    if (!std::isfinite(value) || value == m_value)
        return;
    const int before = place();
    m_value = value;
    if (before != place()) // only on a change, so that a screen reader keeps up
        say();
    update();
}

void TargetBar::say() {
    setAccessibleDescription(words());
}

int TargetBar::place() const {
    if (m_limit > 0.0 && m_value > m_limit)
        return 2;
    if (m_high <= 0.0)
        return 3;
    return m_value < m_low ? -1 : m_value > m_high ? 1 : 0;
}

QString TargetBar::placeText(int at) const {
    switch (at) {
    case -1:
        return tr("below the band");
    case 0:
        return tr("in the band");
    case 1:
        return tr("above the band");
    case 2:
        return tr("over the limit");
    default:
        return {};
    }
}

QString TargetBar::words() const {
    return wordsAt(m_value, place());
}

QString TargetBar::wordsAt(double value, int at) const {
    const QString where = placeText(at);
    if (!m_numbers)
        return where;
    const QString number = m_locale.toString(value, 'f', m_quantity.decimals);
    return where.isEmpty() ? tr("%1 %2").arg(number, m_quantity.unit)
                           : tr("%1 %2, %3").arg(number, m_quantity.unit, where);
}

void TargetBar::fit() {
    QStringList said{wordsAt(m_quantity.end, 3)};
    if (m_high > 0.0)
        for (const int at : {-1, 0, 1})
            said << wordsAt(m_quantity.end, at);
    if (m_limit > 0.0)
        said << wordsAt(m_quantity.end, 2);
    if (m_head.fit(width(), said))
        updateGeometry();
}

void TargetBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fit();
}

void TargetBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Colour ink = place() == 2 ? Colour::bad : place() == 0 ? Colour::good : Colour::text;
    m_head.paint(painter, width(), words(), ink);

    const QRect track(0, m_head.height_px() + m_theme.px(5), width() - 1, m_theme.px(14));
    const auto xOf = [&](double value) {
        return track.left() + qRound(std::clamp(value / m_quantity.end, 0.0, 1.0) * (track.width() - 1));
    };
    painter.setPen(m_theme.color(Colour::borderStrong));
    painter.setBrush(m_theme.color(Colour::raised));
    painter.drawRect(track);
    if (m_high > 0.0)
        painter.fillRect(QRect(xOf(m_low), track.top() + 1, xOf(m_high) - xOf(m_low), track.height() - 1),
                         m_theme.color(Colour::goodSoft));
    // The value's bar is narrower than the track, so that the band remains visible above and below it.
    const QRect filled(track.left() + 1, track.top() + m_theme.px(4), xOf(m_value) - track.left(),
                       track.height() - m_theme.px(8) + 1);
    painter.fillRect(filled, m_theme.color(place() == 2   ? Colour::bad
                                           : place() == 0 ? Colour::good
                                                          : Colour::seriesA));
    if (place() == 2)
        painter.fillRect(filled, QBrush(m_theme.color(Colour::surface), Qt::BDiagPattern));
    painter.setPen(QPen(m_theme.color(Colour::text), m_theme.px(2)));
    const auto line = [&](double value) {
        painter.drawLine(xOf(value), track.top() - m_theme.px(3), xOf(value), track.bottom() + m_theme.px(3));
    };
    if (m_high > 0.0) {
        line(m_low);
        line(m_high);
    }
    if (m_limit > 0.0)
        line(m_limit);
}

} // namespace chiron::desktop
