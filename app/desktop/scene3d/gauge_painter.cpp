// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/gauge_painter.h"

#include <QCoreApplication>
#include <QFont>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {
constexpr QRectF kHollow(12.0, 36.0, 20.0, 248.0); // logical pixels, from the top
}

QRectF GaugePainter::hollow() {
    return kHollow;
}

double largestForce_N(const SceneState& state) {
    double force_N = 0.0;
    for (const ToolView& tool : state.tool)
        if (tool.present)
            force_N = std::max(force_N, tool.force_N.norm());
    return force_N;
}

GaugeDial forceDial(const SceneSetup& setup) {
    GaugeDial dial;
    dial.title = QCoreApplication::translate("chiron::scene3d::ForceGauge", "Force (N)");
    dial.limit_N = setup.forceLimit_N;
    dial.range_N = GaugePainter::kRange * std::max(0.1, setup.forceLimit_N);
    return dial;
}

double GaugePainter::heightOf(double force_N) const {
    return kHollow.bottom() - kHollow.height() * std::min(1.0, force_N / m_dial.range_N);
}

QFont GaugePainter::font(double size, bool bold) const {
    QFont font(m_setup.family);
    font.setPixelSize(std::max(1, int(size * m_text)));
    font.setBold(bold);
    return font;
}

void GaugePainter::paint(QPainter& painter) const {
    painter.setRenderHint(QPainter::Antialiasing);
    QColor card = m_setup.colours.background;
    card.setAlphaF(m_setup.colours.highContrast ? 1.0F : 0.86F);
    QPainterPath frame;
    frame.setFillRule(Qt::OddEvenFill);
    frame.addRoundedRect(QRectF(1, 1, width() - 2, kHeight - 2), 8, 8);
    frame.addRect(kHollow);
    painter.setPen(m_setup.colours.highContrast ? QPen(m_setup.colours.ink, 1.5) : QPen(Qt::NoPen));
    painter.setBrush(card);
    painter.drawPath(frame);
    painter.setPen(m_setup.colours.ink);
    double size = 12.0; // smaller if a language needs more room
    while (size > 8.0 && QFontMetricsF(font(size, true)).horizontalAdvance(m_dial.title) > width() - 8.0)
        size -= 1.0;
    painter.setFont(font(size, true));
    painter.drawText(QRectF(4, 6, width() - 8, 24), Qt::AlignCenter, m_dial.title);
    if (m_dial.bandHigh_N > 0.0)
        paintBand(painter);
    paintScale(painter);
    if (m_dial.limit_N > 0.0)
        paintLimit(painter);
}

void GaugePainter::paintScale(QPainter& painter) const {
    painter.setPen(QPen(m_setup.colours.ink, 1.2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(kHollow);
    painter.setFont(font(12, false));
    const double range_N = m_dial.range_N;
    double step_N = 0.1;
    for (double next : {0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0})
        if (range_N / step_N > 7.0 / m_text)
            step_N = next;
    for (int i = 0; i * step_N <= range_N + 1e-9; ++i) {
        const double y = heightOf(i * step_N);
        painter.drawLine(QPointF(kHollow.right(), y), QPointF(kHollow.right() + 4.0, y));
        if (m_dial.limit_N > 0.0 && std::abs(y - heightOf(m_dial.limit_N)) < 12.0 * m_text)
            continue; // the limit's own number stands there
        painter.drawText(
            QRectF(kHollow.right() + 7.0, y - 9.0 * m_text, width() - kHollow.right() - 9.0, 18.0 * m_text),
            Qt::AlignLeft | Qt::AlignVCenter, QLocale().toString(i * step_N, 'f', step_N < 1.0 ? 1 : 0));
    }
}

/// A bracket beside the hollow and two lines across it, visible over any filling and without relying on
/// colour.
void GaugePainter::paintBand(QPainter& painter) const {
    const double high = heightOf(m_dial.bandHigh_N);
    const double low = heightOf(m_dial.bandLow_N);
    QColor veil = m_setup.colours.ink;
    veil.setAlphaF(0.16F);
    painter.fillRect(QRectF(kHollow.left(), high, kHollow.width(), low - high), veil);
    painter.setPen(QPen(m_setup.colours.ink, 2.2, Qt::SolidLine, Qt::FlatCap));
    for (const double y : {high, low})
        painter.drawLine(QPointF(kHollow.left() - 6.0, y), QPointF(kHollow.right(), y));
    painter.setPen(QPen(m_setup.colours.ink, 4.0, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(kHollow.left() - 6.0, high - 1.1), QPointF(kHollow.left() - 6.0, low + 1.1));
}

void GaugePainter::paintLimit(QPainter& painter) const {
    const double y = heightOf(m_dial.limit_N);
    painter.setPen(QPen(m_setup.colours.ink, 3.0));
    painter.drawLine(QPointF(kHollow.left() - 5.0, y), QPointF(kHollow.right() + 6.0, y));
    painter.setFont(font(13, true));
    const bool whole = std::abs(m_dial.limit_N - std::round(m_dial.limit_N)) < 0.005;
    painter.drawText(
        QRectF(kHollow.right() + 8.0, y - 9.0 * m_text, width() - kHollow.right() - 10.0, 18.0 * m_text),
        Qt::AlignLeft | Qt::AlignVCenter, QLocale().toString(m_dial.limit_N, 'f', whole ? 0 : 1));
}

} // namespace chiron::scene3d
