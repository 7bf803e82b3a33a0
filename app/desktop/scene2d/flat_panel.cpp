// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene2d/flat_panel.h"

#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

// Distances between card and plot, in logical pixels at scale 1.
constexpr double kLeft = 52.0;
constexpr double kRight = 14.0;
constexpr double kTop = 34.0;
constexpr double kBottom = 40.0;
constexpr double kTitleMargin = 12.0;
constexpr double kTick_mm = 20.0;

/// A number fits at every n-th tick; returns n.
int numbered(double number_px, double tick_px) {
    return std::max(1, static_cast<int>(std::ceil(number_px / tick_px)));
}

bool isNumbered(double mm, int every) {
    return static_cast<int>(std::lround(mm / kTick_mm)) % every == 0;
}

} // namespace

FlatPanel::FlatPanel(Side side, const QRectF& range_mm, const SceneSetup& setup)
    : m_side(side), m_range_mm(range_mm), m_setup(setup) {}

double FlatPanel::scaleIn(double height, double scale) {
    return std::min(scale, std::max(0.7, 0.5 * height / (kTop + kBottom)));
}

QSizeF FlatPanel::cardSize(double pixelsPerMm) const {
    return {m_range_mm.width() * pixelsPerMm + (kLeft + kRight) * unit(),
            m_range_mm.height() * pixelsPerMm + (kTop + kBottom) * unit()};
}

void FlatPanel::extendUp(double cardHeight, double pixelsPerMm) {
    m_range_mm.setHeight(
        std::max(m_range_mm.height(), (cardHeight - (kTop + kBottom) * unit()) / pixelsPerMm));
}

void FlatPanel::place(const QPointF& corner, double pixelsPerMm) {
    m_scale = pixelsPerMm;
    m_plot = QRectF(corner.x() + kLeft * unit(), corner.y() + kTop * unit(), m_range_mm.width() * pixelsPerMm,
                    m_range_mm.height() * pixelsPerMm);
}

QPointF FlatPanel::at(double across_mm, double up_mm) const {
    return {m_plot.left() + (across_mm - m_range_mm.left()) * m_scale,
            m_plot.bottom() - (up_mm - m_range_mm.top()) * m_scale};
}

QPointF FlatPanel::project(const core::Vec3& p_m) const {
    return at((m_side == Side::profile ? p_m.y() : p_m.x()) * 1e3,
              (m_side == Side::above ? p_m.y() : p_m.z()) * 1e3);
}

QFont FlatPanel::font(double size, bool bold) const {
    QFont font(m_setup.family);
    font.setPixelSize(std::max(1, int(size * unit())));
    font.setBold(bold);
    return font;
}

QFont FlatPanel::titleFont(const QString& title, QPaintDevice* device) const {
    QFont heading = font(14, true);
    const double room = m_plot.width() + (kLeft + kRight - 2.0 * kTitleMargin) * unit();
    const double wide = QFontMetricsF(heading, device).horizontalAdvance(title);
    if (wide > room)
        heading.setPixelSize(std::max(1, static_cast<int>(heading.pixelSize() * room / wide)));
    // With hinting, the width is not exactly proportional to the size.
    while (heading.pixelSize() > 1 && QFontMetricsF(heading, device).horizontalAdvance(title) > room)
        heading.setPixelSize(heading.pixelSize() - 1);
    return heading;
}

void FlatPanel::paintCard(QPainter& painter, const QString& title, const QString& across,
                          const QString& up) const {
    const double u = unit();
    const QRectF card = m_plot.adjusted(-kLeft * u, -kTop * u, kRight * u, kBottom * u);
    painter.setPen(m_setup.colours.highContrast ? QPen(m_setup.colours.ink, 1.5 * u) : QPen(Qt::NoPen));
    painter.setBrush(m_setup.colours.field);
    painter.drawRoundedRect(card, 8.0 * u, 8.0 * u);
    painter.setPen(m_setup.colours.ink);
    painter.setFont(titleFont(title, painter.device()));
    painter.drawText(
        QRectF(card.left() + kTitleMargin * u, card.top(), card.width() - 2.0 * kTitleMargin * u, kTop * u),
        Qt::AlignLeft | Qt::AlignVCenter, title);
    paintTicks(painter);
    painter.setPen(m_setup.colours.ink);
    painter.setFont(font(12, false));
    painter.drawText(QRectF(m_plot.left(), m_plot.bottom() + 20.0 * u, m_plot.width(), 18.0 * u),
                     Qt::AlignCenter, across);
    painter.save();
    painter.translate(card.left() + 4.0 * u, m_plot.center().y());
    painter.rotate(-90.0);
    painter.drawText(QRectF(-m_plot.height() / 2.0, 0.0, m_plot.height(), 16.0 * u), Qt::AlignCenter, up);
    painter.restore();
}

void FlatPanel::paintTicks(QPainter& painter) const {
    const double u = unit();
    painter.setFont(font(11, false));
    QColor grid = m_setup.colours.ink;
    grid.setAlphaF(0.14F);
    const QFontMetricsF metrics(painter.font(), painter.device());
    const QString widest = QLocale().toString(std::min(m_range_mm.left(), -m_range_mm.right()), 'f', 0);
    const int across = numbered(metrics.horizontalAdvance(widest) + 4.0 * u, kTick_mm * m_scale);
    const int up = numbered(metrics.height(), kTick_mm * m_scale);
    for (double mm = std::ceil(m_range_mm.left() / kTick_mm) * kTick_mm; mm <= m_range_mm.right();
         mm += kTick_mm) {
        const double x = at(mm, 0.0).x();
        painter.setPen(QPen(grid, u));
        painter.drawLine(QPointF(x, m_plot.top()), QPointF(x, m_plot.bottom()));
        if (!isNumbered(mm, across))
            continue;
        painter.setPen(m_setup.colours.ink);
        painter.drawText(QRectF(x - 20.0 * u, m_plot.bottom() + 3.0 * u, 40.0 * u, 16.0 * u), Qt::AlignCenter,
                         QLocale().toString(mm, 'f', 0));
    }
    for (double mm = std::ceil(m_range_mm.top() / kTick_mm) * kTick_mm; mm <= m_range_mm.bottom();
         mm += kTick_mm) {
        const double y = at(0.0, mm).y();
        painter.setPen(QPen(grid, u));
        painter.drawLine(QPointF(m_plot.left(), y), QPointF(m_plot.right(), y));
        if (!isNumbered(mm, up))
            continue;
        painter.setPen(m_setup.colours.ink);
        painter.drawText(QRectF(m_plot.left() - 34.0 * u, y - 8.0 * u, 29.0 * u, 16.0 * u),
                         Qt::AlignRight | Qt::AlignVCenter, QLocale().toString(mm, 'f', 0));
    }
}

} // namespace chiron::scene3d
