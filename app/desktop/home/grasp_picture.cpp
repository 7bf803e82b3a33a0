// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/home/grasp_picture.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

void GraspPicture::paintFloor(QPainter& painter, double y) const {
    QRectF field(0, 0, width() * 1.25, height() * 0.40);
    field.moveCenter({width() * 0.5, y + height() * 0.06});
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_theme.color(Colour::sceneField));
    painter.drawEllipse(field);
}

void GraspPicture::paintGrasper(QPainter& painter, QPointF tip, QPointF from, double opening) const {
    const QPointF way = from - tip;
    const double length = std::hypot(way.x(), way.y());
    const QPointF along = way / length;
    const QPointF beside(-along.y(), along.x());
    const double thick = std::max(3.0, width() * 0.026);
    const QPointF joint = tip + 0.20 * width() * along;
    painter.setPen(QPen(m_theme.color(Colour::borderStrong), thick, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(joint, from);
    painter.setPen(QPen(m_theme.color(Colour::surface), thick * 0.3, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(joint - 0.15 * thick * beside, from - 0.15 * thick * beside);
    for (const double side : {0.5, -0.5}) {
        const QPointF end = tip + side * opening * beside;
        const QPointF bow = 0.5 * (joint + end) + side * (0.35 * opening + 0.6 * thick) * beside;
        QPainterPath blade(joint);
        blade.quadTo(bow, end);
        painter.setPen(
            QPen(m_theme.color(Colour::text), std::max(2.0, thick * 0.42), Qt::SolidLine, Qt::RoundCap));
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(blade);
    }
}

} // namespace chiron::desktop
