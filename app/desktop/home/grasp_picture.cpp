// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of exercises with graspers, from the side: tube, objects and dish in their true proportions.
#include "desktop/home/exercise_picture.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

using simulation::HandlingTask;
using simulation::TubeTask;

namespace {
constexpr double kPictureWidth_m = 0.150;
constexpr double kFloorAt = 0.80; // of the picture's height, from the top
} // namespace

void ExercisePicture::paintFloor(QPainter& painter, double y) const {
    QRectF field(0, 0, width() * 1.25, height() * 0.40);
    field.moveCenter({width() * 0.5, y + height() * 0.06});
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_theme.color(Colour::sceneField));
    painter.drawEllipse(field);
}

/// Shaft from outside, two blades to the tip; `opening` between their ends, pixels.
void ExercisePicture::paintGrasper(QPainter& painter, QPointF tip, QPointF from, double opening) const {
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
        painter.setPen(QPen(m_theme.color(Colour::text), std::max(2.0, thick * 0.42), Qt::SolidLine, Qt::RoundCap));
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(blade);
    }
}

void ExercisePicture::paintTube(QPainter& painter) const {
    const double perMetre = width() / kPictureWidth_m;
    const double floor = height() * kFloorAt;
    paintFloor(painter, floor);
    const bool two = m_tube->tools() > 1;
    const bool free = m_tube->task == TubeTask::twoHanded;
    const double long_px = std::min(1.45 * m_tube->restLength_m * perMetre, floor - height() * 0.22);
    const QPointF base = free ? QPointF(width() * 0.5 - 0.62 * long_px, floor - height() * 0.34) : QPointF(width() * 0.40, floor);
    const QPointF end = free ? QPointF(width() * 0.5 + 0.62 * long_px, floor - height() * 0.38)
                             : base + QPointF(0.42 * long_px, -0.90 * long_px);
    const double thick = std::max(5.0, 2.6 * m_tube->radius_m * perMetre);
    const QColor tissue = m_theme.color(Colour::seriesB);
    QPainterPath tube(base);
    tube.quadTo(0.5 * (base + end) + QPointF(0.05 * long_px, free ? 0.10 * long_px : 0.04 * long_px), end);
    painter.setBrush(Qt::NoBrush);
    const Qt::PenStyle style = m_visible ? Qt::SolidLine : Qt::DashLine;
    painter.setPen(QPen(m_visible ? tissue.darker(160) : m_theme.color(Colour::text), thick + (m_visible ? 3.0 : 0.0), style, Qt::RoundCap));
    if (m_visible)
        painter.drawPath(tube);
    painter.setPen(QPen(m_visible ? tissue.lighter(130) : m_theme.color(Colour::text), m_visible ? thick : 2.0, style, Qt::RoundCap));
    painter.drawPath(tube);
    if (!free) { // its foot
        painter.setPen(Qt::NoPen);
        painter.setBrush(tissue.darker(120));
        painter.drawEllipse(base, thick * 1.1, thick * 0.4);
    }
    const QPointF mark = m_tube->task == TubeTask::transfer ? QPointF(width() * 0.20, floor - m_tube->targetZ_m * perMetre) : end;
    if (m_tube->task == TubeTask::transfer || m_tube->task == TubeTask::stretch) {
        const double ring = std::max(0.06 * width(), m_tube->targetRadius_m * perMetre);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(m_theme.color(Colour::accent), std::max(2.0, width() * 0.014), Qt::DashLine));
        painter.drawEllipse(mark, ring, ring);
    }
    if (two) {
        const QPointF other = free ? base : base + 0.74 * (end - base);
        paintGrasper(painter, other, {-0.02 * width(), height() * 0.02}, thick);
    }
    paintGrasper(painter, end, {1.02 * width(), height() * (free ? 0.02 : -0.05)}, thick);
}

void ExercisePicture::paintHandling(QPainter& painter) const {
    const double perMetre = width() / kPictureWidth_m;
    const double floor = height() * kFloorAt;
    paintFloor(painter, floor);
    const double radius = m_handling->radius_m * perMetre;
    const QColor steel = m_theme.color(Colour::borderStrong);
    QPainterPath dish; // the target, from the side
    const double half = m_handling->targetRadius_m * perMetre;
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
        painter.setPen(QPen(m_visible ? white.darker(190) : m_theme.color(Colour::text), std::max(1.2, width() * 0.008),
                            m_visible ? Qt::SolidLine : Qt::DashLine));
        painter.drawEllipse(centre, radius / flat, radius * flat);
    };
    for (int i = 1; i < m_handling->objects; ++i)
        ovary({width() * (0.46 + 0.22 * i), floor - 0.8 * radius}, 1.0);
    if (m_handling->organBed) { // the organ under it
        painter.setPen(QPen(m_theme.color(Colour::seriesB).darker(150), std::max(1.2, width() * 0.008)));
        painter.setBrush(m_theme.color(Colour::seriesB));
        painter.drawEllipse(QPointF(width() * 0.62, floor + height() * 0.06), width() * 0.22, height() * 0.13);
    }
    const QPointF lifted(width() * 0.50, floor - height() * 0.36);
    ovary(lifted, 0.92);
    paintGrasper(painter, lifted, {1.02 * width(), height() * 0.0}, 1.9 * radius);
}

} // namespace chiron::desktop
