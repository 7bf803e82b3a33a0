// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene2d/flat_comparison.h"

#include "cues/laparoscopy_cues.h"
#include "desktop/scene2d/laparoscopy/flat_floor.h"
#include "simulation/comparison/comparison_parameters.h"

#include <QPainter>
#include <QRadialGradient>
#include <algorithm>

namespace chiron::scene3d {

namespace {

void paintNumber(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup, const QPointF& at,
                 int number) {
    constexpr double kHigh = 16.0;
    QFont font = painter.font();
    font.setPixelSize(std::max(1, static_cast<int>(0.8 * kHigh * panel.unit())));
    font.setBold(true);
    painter.save();
    painter.setFont(font);
    painter.setPen(setup.colours.ink);
    painter.drawText(QRectF(at.x() - kHigh * panel.unit(), at.y() - 0.5 * kHigh * panel.unit(),
                            2.0 * kHigh * panel.unit(), kHigh * panel.unit()),
                     Qt::AlignCenter, QString::number(number));
    painter.restore();
}

} // namespace

FlatFrame FlatComparison::frame() const {
    return {FlatFloor::rangeAbove_mm(), FlatFloor::rangeSide_mm(84.0)};
}

void FlatComparison::paint(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                           const SceneState& state) const {
    FlatFloor::paint(painter, panel, setup);
    const core::LaparoscopyCues& cues = state.exercise.of<core::LaparoscopyCues>();
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
        // The number by which answers and messages identify the object.
        if (cues.bodies > 1)
            paintNumber(painter, panel, setup, at + QPointF(0.0, -radius - 12.0 * panel.unit()), i + 1);
    }
}

std::vector<std::string> FlatComparison::marks(const simulation::ComparisonParameters&,
                                               const MarkedScene& scene) {
    return stageMarks(scene.setup, 1);
}

} // namespace chiron::scene3d
