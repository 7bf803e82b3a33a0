// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/elastic_tube/desktop/tube_picture.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

namespace chiron::desktop {

using simulation::TubeTask;

void TubePicture::paint(QPainter& painter) const {
    const double perMetre = width() / kPictureWidth_m;
    const double floor = height() * kFloorAt;
    paintFloor(painter, floor);
    const bool two = m_level.tools() > 1;
    const bool free = m_level.task == TubeTask::twoHanded;
    const double long_px = std::min(1.45 * m_level.restLength_m * perMetre, floor - height() * 0.22);
    const QPointF base = free ? QPointF(width() * 0.5 - 0.62 * long_px, floor - height() * 0.34)
                              : QPointF(width() * 0.40, floor);
    const QPointF end = free ? QPointF(width() * 0.5 + 0.62 * long_px, floor - height() * 0.38)
                             : base + QPointF(0.42 * long_px, -0.90 * long_px);
    const double thick = std::max(5.0, 2.6 * m_level.radius_m * perMetre);
    const QColor tissue = m_theme.color(Colour::seriesB);
    QPainterPath tube(base);
    tube.quadTo(0.5 * (base + end) + QPointF(0.05 * long_px, free ? 0.10 * long_px : 0.04 * long_px), end);
    painter.setBrush(Qt::NoBrush);
    const Qt::PenStyle style = m_visible ? Qt::SolidLine : Qt::DashLine;
    painter.setPen(QPen(m_visible ? tissue.darker(160) : m_theme.color(Colour::text),
                        thick + (m_visible ? 3.0 : 0.0), style, Qt::RoundCap));
    if (m_visible)
        painter.drawPath(tube);
    painter.setPen(QPen(m_visible ? tissue.lighter(130) : m_theme.color(Colour::text),
                        m_visible ? thick : 2.0, style, Qt::RoundCap));
    painter.drawPath(tube);
    if (!free) { // the foot of the tube
        painter.setPen(Qt::NoPen);
        painter.setBrush(tissue.darker(120));
        painter.drawEllipse(base, thick * 1.1, thick * 0.4);
    }
    const QPointF mark = m_level.task == TubeTask::transfer
                             ? QPointF(width() * 0.20, floor - m_level.targetZ_m * perMetre)
                             : end;
    if (m_level.task == TubeTask::transfer || m_level.task == TubeTask::stretch) {
        const double ring = std::max(0.06 * width(), m_level.targetRadius_m * perMetre);
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

} // namespace chiron::desktop
