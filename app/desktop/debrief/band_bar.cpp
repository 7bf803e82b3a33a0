// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/debrief/band_bar.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

BandBar::BandBar(const Theme& theme, const report::MetricRow& row, QWidget* parent)
    : QWidget(parent), m_theme(theme), m_row(row) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    double low = 0.0; // the scale always includes zero
    double high = 0.0;
    for (const auto& value : {row.value, row.bandLow, row.bandHigh, row.gateMinimum, row.gateMaximum}) {
        if (value && std::isfinite(*value)) {
            low = std::min(low, *value);
            high = std::max(high, *value);
        }
    }
    if (!(high > low))
        high = low + 1.0;
    const double margin = 0.12 * (high - low);
    m_low = low < 0.0 ? low - margin : low;
    m_high = high > 0.0 ? high + margin : high;
}

QSize BandBar::sizeHint() const {
    return {m_theme.px(180), m_theme.px(34)};
}

double BandBar::placeOf(double value) const {
    return std::clamp((value - m_low) / (m_high - m_low), 0.0, 1.0);
}

QRectF BandBar::bar() const {
    const double inset = m_theme.px(8);
    return QRectF(inset, height() - m_theme.px(14), width() - 2.0 * inset, m_theme.px(6));
}

double BandBar::xOf(double value) const {
    return bar().left() + bar().width() * placeOf(value);
}

void BandBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF groove = bar();
    const double unit = m_theme.px(1);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_theme.color(Colour::border));
    painter.drawRoundedRect(groove, 2 * unit, 2 * unit);
    if (m_row.bandLow && m_row.bandHigh) {
        painter.setPen(QPen(m_theme.color(Colour::good), unit));
        painter.setBrush(m_theme.color(Colour::goodSoft));
        painter.drawRect(QRectF(QPointF(xOf(*m_row.bandLow), groove.top() - 4 * unit),
                                QPointF(xOf(*m_row.bandHigh), groove.bottom() + 4 * unit)));
    }
    painter.setPen(QPen(m_theme.color(Colour::bad), 2 * unit));
    for (const auto& gate : {m_row.gateMinimum, m_row.gateMaximum})
        if (gate)
            painter.drawLine(QPointF(xOf(*gate), groove.top() - 7 * unit),
                             QPointF(xOf(*gate), groove.bottom() + 7 * unit));
    if (!m_row.value || !std::isfinite(*m_row.value))
        return;
    const double x = xOf(*m_row.value);
    painter.setPen(QPen(m_theme.color(Colour::surface), unit));
    painter.setBrush(m_theme.color(Colour::text));
    painter.drawPolygon(
        QPolygonF({QPointF(x, groove.center().y()), QPointF(x - 6 * unit, groove.top() - 11 * unit),
                   QPointF(x + 6 * unit, groove.top() - 11 * unit)}));
}

} // namespace chiron::desktop
