// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/palpation_picture.h"

#include "simulation/palpation/tissue_surface.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {
constexpr double kPress_m = 0.004; // depth to which the drawn finger presses
constexpr double kWide_m = 0.016;  // width of a finger
} // namespace

void PalpationPicture::paint(QPainter& painter) const {
    const simulation::TissueSurface surface(m_level.tissue.shape);
    const double half_m = m_level.areaHalf_m.x() + 0.012;
    const double perMetre = width() / (2.0 * half_m);
    const double base =
        height() * 0.62 + 0.6 * (surface.highest_m() - m_level.tissue.shape.planeHeight_m) * perMetre;
    const bool two = m_level.hands > 1;
    const double finger_m = two ? 0.40 * half_m : 0.0;
    const auto dent_m = [&](double x_m) {
        double depth_m = 0.0;
        for (const double at_m : {finger_m, two ? -finger_m : finger_m}) {
            const double r = (x_m - at_m) / (3.0 * m_level.tissue.contactRadius_m);
            depth_m = std::max(depth_m, kPress_m * std::pow(std::max(0.0, 1.0 - r * r), 3));
        }
        return depth_m;
    };
    const auto at = [&](double x_m) {
        const double z_m =
            surface.heightAt({x_m, 0.0}).z_m - m_level.tissue.shape.planeHeight_m - dent_m(x_m);
        return QPointF(0.5 * width() + x_m * perMetre, base - z_m * perMetre);
    };
    QPolygonF edge;
    for (double x_m = -half_m; x_m <= half_m + 1e-9; x_m += half_m / 60.0)
        edge << at(x_m);
    QPainterPath body;
    body.addPolygon(edge);
    body.lineTo(width() + 2.0, edge.last().y());
    body.lineTo(width() + 2.0, height() + 2.0);
    body.lineTo(-2.0, height() + 2.0);
    body.lineTo(-2.0, edge.first().y());
    const QColor tissue = m_theme.color(Colour::seriesB);
    QLinearGradient deep(0.0, edge.boundingRect().top(), 0.0, height());
    deep.setColorAt(0.0, tissue.lighter(165));
    deep.setColorAt(1.0, tissue.darker(115));
    painter.fillPath(body, deep);
    painter.setPen(QPen(tissue.darker(170), std::max(1.5, width() * 0.009)));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(edge);
    if (!m_level.kinds.empty() && m_level.lumpsHigh > 0) { // dashed if it has to be found by touch
        const simulation::LumpKind& kind = m_level.kinds.front();
        const double radius = kind.radius_m * perMetre;
        const QPointF lump = at(0.55 * half_m) + QPointF(0.0, kind.depth_m * perMetre);
        painter.setBrush(m_visible ? QBrush(tissue.darker(200)) : QBrush(Qt::NoBrush));
        painter.setPen(QPen(m_visible ? tissue.darker(260) : m_theme.color(Colour::text),
                            std::max(1.5, width() * 0.009), m_visible ? Qt::SolidLine : Qt::DashLine));
        painter.drawEllipse(lump, radius, radius);
    }
    paintFinger(painter, at(finger_m), false, perMetre);
    if (two)
        paintFinger(painter, at(-finger_m), true, perMetre);
}

void PalpationPicture::paintFinger(QPainter& painter, QPointF tip, bool fromLeft, double perMetre) const {
    const double wide = kWide_m * perMetre;
    const double way = fromLeft ? -1.0 : 1.0;
    QPainterPath line(tip + QPointF(0.0, -0.5 * wide));
    line.lineTo(tip + QPointF(0.9 * way * wide, -0.95 * wide));
    line.lineTo(tip + QPointF(2.6 * way * wide, -2.6 * wide));
    line.lineTo(tip + QPointF(6.0 * way * wide, -4.6 * wide));
    const QColor glove = m_theme.color(Colour::accent);
    const double edge = std::max(2.0, width() * 0.012);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(glove.darker(150), wide, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(line);
    painter.setPen(
        QPen(glove.lighter(115), std::max(1.0, wide - edge), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(line);
}

} // namespace chiron::desktop
