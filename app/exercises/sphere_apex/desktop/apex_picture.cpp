// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/sphere_apex/desktop/apex_picture.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

void ApexPicture::paint(QPainter& painter) const {
    // The field is 130 mm wide; the picture shows the middle 100 mm.
    const double perMetre = width() / 0.100;
    const double ball = m_ball.radius_m * perMetre;
    const QPointF centre(width() * 0.5, height() * 0.80);
    QRectF field(0, 0, width() * 1.25, height() * 0.42);
    field.moveCenter(centre + QPointF(0, height() * 0.02));
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_theme.color(Colour::sceneField));
    painter.drawEllipse(field);
    paintBall(painter, centre, ball);
    paintTool(painter, centre - QPointF(0, ball), height() * 0.95);
}

void ApexPicture::paintBall(QPainter& painter, QPointF centre, double radius) const {
    QPainterPath dome; // a hemisphere on the field, seen slightly from above
    dome.moveTo(centre.x() - radius, centre.y());
    dome.arcTo(QRectF(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius), 180, -180);
    dome.arcTo(QRectF(centre.x() - radius, centre.y() - radius * 0.22, 2 * radius, radius * 0.44), 0, -180);
    dome.closeSubpath();
    const QColor ink = m_theme.color(Colour::seriesB);
    if (!m_visible) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(m_theme.color(Colour::text), std::max(1.5, radius * 0.04), Qt::DashLine));
        painter.drawPath(dome);
        return;
    }
    QRadialGradient light(centre - QPointF(radius * 0.35, radius * 0.65), radius * 1.5);
    light.setColorAt(0.0, ink.lighter(165));
    light.setColorAt(0.45, ink);
    light.setColorAt(1.0, ink.darker(165));
    painter.setPen(Qt::NoPen);
    painter.setBrush(light);
    painter.drawPath(dome);
    if (m_ball.dimpleDepth_m > 0.0) {
        const double half = radius * m_ball.dimpleRadius_m / m_ball.radius_m;
        const double offset = radius * m_ball.dimpleOffset_m / m_ball.radius_m;
        const double up = std::sqrt(std::max(0.0, radius * radius - offset * offset));
        painter.setBrush(ink.darker(190));
        painter.translate(centre + QPointF(offset, -up * 0.86));
        painter.rotate(28);
        painter.drawEllipse(QPointF(0, 0), half * 0.9, half * 0.42);
        painter.resetTransform();
    }
}

void ApexPicture::paintTool(QPainter& painter, QPointF tip, double length) const {
    const QPointF end = tip + QPointF(length * 0.62, -length * 0.78);
    const double thick = std::max(4.0, width() * 0.032);
    painter.setPen(QPen(m_theme.color(Colour::borderStrong), thick, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(tip, end);
    painter.setPen(QPen(m_theme.color(Colour::surface), thick * 0.35, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(tip + QPointF(-thick * 0.15, -thick * 0.15),
                     end + QPointF(-thick * 0.15, -thick * 0.15));
    painter.setPen(QPen(m_theme.color(Colour::sceneBackground), 2));
    painter.setBrush(m_theme.color(Colour::accent));
    painter.drawEllipse(tip, thick * 0.75, thick * 0.75);
}

} // namespace chiron::desktop
