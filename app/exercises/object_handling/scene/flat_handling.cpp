// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/object_handling/scene/flat_handling.h"

#include "app/exercises/object_handling/scene/squeezed.h"
#include "core/units.h"
#include "desktop/scene2d/laparoscopy/flat_floor.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace chiron::scene3d {

namespace {

/// The outline of the mapped unit ball in this picture: the extent, in each direction, of the map's two rows
/// that the picture shows.
QPolygonF outline(const FlatPanel& panel, const core::Vec3& p_W, const core::Mat3& map) {
    const int up = panel.side() == FlatPanel::Side::above ? 1 : 2;
    const core::Vec3 across = map.row(0).transpose();
    const core::Vec3 upwards = map.row(up).transpose();
    QPolygonF polygon;
    for (int i = 0; i < 48; ++i) {
        const double angle = 2.0 * core::kPi * i / 48;
        const core::Vec3 seen = std::cos(angle) * across + std::sin(angle) * upwards;
        const core::Vec3 u =
            seen.norm() > 1e-12 ? core::Vec3(seen.normalized()) : core::Vec3(core::Vec3::UnitX());
        polygon << panel.project(p_W + map * u);
    }
    return polygon;
}

void paintBody(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup, const SceneState& state,
               const core::BodyCue& body) {
    core::Vec3 jaws = core::Vec3::UnitX();
    for (std::size_t i = 0; i < state.tool.size(); ++i)
        if ((body.heldBy >> i & 1) != 0)
            jaws = state.tool[i].q_WT * core::Vec3::UnitY();
    const core::Vec3 p_W(body.p_W[0], body.p_W[1], body.p_W[2]);
    const QPolygonF edge = outline(panel, p_W, squeezed(body, jaws));
    QRadialGradient light(panel.project(p_W) - QPointF(0.3, 0.35) * panel.pixels(body.radius_m * 1e3),
                          panel.pixels(body.radius_m * 1.6e3));
    light.setColorAt(0.0, QColor(252, 244, 234));
    light.setColorAt(0.6, QColor(234, 214, 202));
    light.setColorAt(1.0, QColor(186, 150, 142));
    painter.setBrush(light);
    const bool held = body.heldBy != 0;
    painter.setPen(QPen(held ? setup.colours.ink : flat_tissue::kEdge, (held ? 3.0 : 1.5) * panel.unit()));
    painter.drawPolygon(edge);
}

} // namespace

FlatFrame FlatHandling::frame() const {
    return {FlatFloor::rangeAbove_mm(), FlatFloor::rangeSide_mm(84.0)};
}

void FlatHandling::paint(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                         const SceneState& state) const {
    FlatFloor::paint(painter, panel, setup);
    const core::LaparoscopyCues& cues = state.exercise.of<core::LaparoscopyCues>();
    if (!cues.present || !cues.objectShown)
        return;
    if (cues.targetShown)
        FlatFloor::paintTarget(painter, panel, setup, {cues.p_WTarget[0], cues.p_WTarget[1], 0.0},
                               cues.targetRadius_m, cues.dwell);
    for (int i = 0; i < cues.bodies; ++i)
        paintBody(painter, panel, setup, state, cues.body[static_cast<std::size_t>(i)]);
}

std::vector<std::string> FlatHandling::marks(const simulation::ObjectHandlingParameters&,
                                             const MarkedScene& scene) {
    std::vector<std::string> marks = stageMarks(scene.setup, 1);
    if (scene.setup.cues.object)
        marks.push_back("target_ring");
    return marks;
}

} // namespace chiron::scene3d
