// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene2d/comparison/flat_comparison.h"

#include "desktop/scene2d/laparoscopy/flat_floor.h"

#include <QPainter>
#include <QRadialGradient>

namespace chiron::scene3d {

QRectF FlatComparison::rangeAbove_mm() const { return FlatFloor::rangeAbove_mm(); }

QRectF FlatComparison::rangeSide_mm() const { return FlatFloor::rangeSide_mm(84.0); }

void FlatComparison::paint(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup, const SceneState& state) const {
    FlatFloor::paint(painter, panel, setup);
    const core::LaparoscopyCues& cues = state.laparoscopy;
    if (!cues.present || !cues.objectShown)
        return;
    for (int i = 0; i < cues.bodies; ++i) {
        const core::BodyCue& body = cues.body[static_cast<std::size_t>(i)];
        const core::Vec3 top(body.p_W[0], body.p_W[1], body.p_W[2]);
        const QPointF at = panel.project(top);
        const bool touched = body.heldBy != 0;
        painter.setPen(QPen(setup.colours.ink, (touched ? 3.0 : 1.5) * panel.unit()));
        painter.setBrush(QColor(234, 214, 202));
        if (panel.side() == FlatPanel::Side::side && simulation::isHooked(m_parameters.attribute))
            painter.drawLine(panel.project({top.x(), top.y(), 0.0}), at);
        const double radius = panel.pixels(body.radius_m * 1e3);
        if (panel.side() == FlatPanel::Side::side && !simulation::isHooked(m_parameters.attribute))
            painter.drawRect(QRectF(at.x() - radius, at.y(), 2.0 * radius, panel.pixels(4.0)));
        else
            painter.drawEllipse(at, radius, radius);
    }
}

} // namespace chiron::scene3d
