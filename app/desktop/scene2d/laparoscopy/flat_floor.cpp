// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene2d/laparoscopy/flat_floor.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

QRectF FlatFloor::rangeAbove_mm() {
    return {-kReach_mm, -kReach_mm, 2.0 * kReach_mm, 2.0 * kReach_mm};
}

QRectF FlatFloor::rangeSide_mm(double room_mm) {
    return {-kReach_mm, -8.0, 2.0 * kReach_mm, 8.0 + room_mm};
}

void FlatFloor::paint(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup) {
    const bool above = panel.side() == FlatPanel::Side::above;
    const double edge = (setup.colours.highContrast ? 2.5 : 1.5) * panel.unit();
    if (above) {
        const QPointF middle = panel.at(0.0, 0.0);
        const double reach = panel.pixels(kReach_mm - 3.0);
        QRadialGradient light(middle, reach);
        light.setColorAt(0.0, flat_tissue::kLight);
        light.setColorAt(1.0, flat_tissue::kMiddle);
        painter.setBrush(light);
        painter.setPen(QPen(flat_tissue::kEdge, edge));
        painter.drawEllipse(middle, reach, reach);
        return;
    }
    const double floor = panel.at(0.0, 0.0).y();
    const QRectF ground(panel.plot().left(), floor, panel.plot().width(),
                        std::max(0.0, panel.plot().bottom() - floor));
    QLinearGradient depth(ground.topLeft(), ground.bottomLeft());
    depth.setColorAt(0.0, flat_tissue::kLight);
    depth.setColorAt(1.0, flat_tissue::kDeep);
    painter.fillRect(ground, depth);
    painter.setPen(QPen(flat_tissue::kEdge, edge));
    painter.drawLine(ground.topLeft(), ground.topRight());
}

void FlatFloor::paintTarget(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                            const core::Vec3& p_W, double radius_m, double dwell) {
    const QPointF at = panel.project(p_W);
    const double radius = panel.pixels(radius_m * 1e3);
    const bool floor = panel.side() == FlatPanel::Side::side && p_W.z() < 0.004; // a dish seen from the side
    const double high = floor ? 3.0 * panel.unit() : radius;
    QColor veil = setup.colours.arrow;
    veil.setAlphaF(0.45F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(veil);
    const double filled = std::sqrt(std::clamp(dwell, 0.0, 1.0));
    painter.drawEllipse(at, radius * filled, high * filled);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(setup.colours.background, 5.0 * panel.unit()));
    painter.drawEllipse(at, radius, high);
    painter.setPen(QPen(setup.colours.ink, 2.5 * panel.unit(), Qt::DashLine));
    painter.drawEllipse(at, radius, high);
    painter.setPen(QPen(setup.colours.ink, 2.5 * panel.unit()));
    for (const QPointF& out : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
        painter.drawLine(at + QPointF(out.x() * radius, out.y() * high),
                         at + 0.7 * QPointF(out.x() * radius, out.y() * high));
}

} // namespace chiron::scene3d
