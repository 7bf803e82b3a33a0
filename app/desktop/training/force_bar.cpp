// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/force_bar.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {
constexpr double kReach = 1.25; // multiple of the limit, so that a value above it is visibly above
} // namespace

ForceBar::ForceBar(const Theme& theme, const QLocale& locale, Quantity quantity, bool numbers,
                   QWidget* parent)
    : QWidget(parent), m_theme(theme), m_locale(locale), m_quantity(std::move(quantity)),
      m_head(theme, m_quantity.name), m_numbers(numbers) {
    setAccessibleName(m_quantity.name);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize ForceBar::sizeHint() const {
    return {m_theme.px(200), m_theme.px(40) + m_head.extra_px()};
}

void ForceBar::setValue(double value) {
    if (!std::isfinite(value) || value == m_value)
        return;
    const bool wasOver = isOver();
    m_value = value;
    if (wasOver != isOver())
        setAccessibleDescription(words(m_value));
    update();
}

QString ForceBar::words(double value) const {
    if (!m_numbers)
        return isOver(value) ? tr("over the limit") : QString();
    const QString number = m_locale.toString(value, 'f', m_quantity.decimals);
    return isOver(value) ? tr("%1 %2, over the limit").arg(number, m_quantity.unit)
                         : tr("%1 %2").arg(number, m_quantity.unit);
}

void ForceBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    const double over = kReach * m_quantity.limit;
    if (m_head.fit(width(), {words(over)}))
        updateGeometry();
}

void ForceBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    m_head.paint(painter, width(), words(m_value), isOver() ? Colour::bad : Colour::text);

    const QRect track(0, m_head.height_px() + m_theme.px(4), width() - 1, m_theme.px(14));
    painter.setPen(m_theme.color(Colour::borderStrong));
    painter.setBrush(m_theme.color(Colour::raised));
    painter.drawRect(track);
    const double share = std::clamp(m_value / (m_quantity.limit * kReach), 0.0, 1.0);
    const QRect filled(track.left() + 1, track.top() + 1, qRound(share * (track.width() - 1)),
                       track.height() - 1);
    painter.fillRect(filled, m_theme.color(isOver() ? Colour::bad : Colour::seriesA));
    const int limitX = track.left() + qRound(track.width() / kReach);
    if (isOver()) // not shown by colour alone
        painter.fillRect(filled, QBrush(m_theme.color(Colour::surface), Qt::BDiagPattern));
    painter.setPen(QPen(m_theme.color(Colour::text), m_theme.px(2)));
    painter.drawLine(limitX, track.top() - m_theme.px(3), limitX, track.bottom() + m_theme.px(3));
}

} // namespace chiron::desktop
