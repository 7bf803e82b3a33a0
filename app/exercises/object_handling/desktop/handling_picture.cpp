// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/object_handling/desktop/handling_picture.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

namespace chiron::desktop {

void HandlingPicture::paint(QPainter& painter) const {
    const double perMetre = width() / kPictureWidth_m;
    const double floor = height() * kFloorAt;
    paintFloor(painter, floor);
    const double radius = m_level.radius_m * perMetre;
    const QColor steel = m_theme.color(Colour::borderStrong);
    QPainterPath dish; // the target, from the side
    const double half = m_level.targetRadius_m * perMetre;
    const QPointF at(width() * 0.24, floor + height() * 0.03);
    dish.moveTo(at + QPointF(-half * 1.2, -height() * 0.05));
    dish.quadTo(at + QPointF(-half, height() * 0.02), at + QPointF(0, height() * 0.02));
    dish.quadTo(at + QPointF(half, height() * 0.02), at + QPointF(half * 1.2, -height() * 0.05));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(steel, std::max(3.0, width() * 0.02), Qt::SolidLine, Qt::RoundCap));
    painter.drawPath(dish);
    const auto ovary = [&](QPointF centre, double flat) {
        const QColor white = m_theme.color(Colour::seriesB).lighter(175);
        QRadialGradient light(centre - QPointF(0.3 * radius, 0.4 * radius), radius * 1.6);
        light.setColorAt(0.0, white.lighter(112));
        light.setColorAt(0.6, white);
        light.setColorAt(1.0, white.darker(140));
        painter.setBrush(m_visible ? QBrush(light) : QBrush(Qt::NoBrush));
        painter.setPen(QPen(m_visible ? white.darker(190) : m_theme.color(Colour::text),
                            std::max(1.2, width() * 0.008), m_visible ? Qt::SolidLine : Qt::DashLine));
        painter.drawEllipse(centre, radius / flat, radius * flat);
    };
    for (int i = 1; i < m_level.objects; ++i)
        ovary({width() * (0.46 + 0.22 * i), floor - 0.8 * radius}, 1.0);
    if (m_level.organBed) { // the organ under it
        painter.setPen(QPen(m_theme.color(Colour::seriesB).darker(150), std::max(1.2, width() * 0.008)));
        painter.setBrush(m_theme.color(Colour::seriesB));
        painter.drawEllipse(QPointF(width() * 0.62, floor + height() * 0.06), width() * 0.22,
                            height() * 0.13);
    }
    const QPointF lifted(width() * 0.50, floor - height() * 0.36);
    ovary(lifted, 0.92);
    paintGrasper(painter, lifted, {1.02 * width(), height() * 0.0}, 1.9 * radius);
}

} // namespace chiron::desktop
