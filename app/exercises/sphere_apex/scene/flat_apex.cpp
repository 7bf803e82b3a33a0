// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/sphere_apex/scene/flat_apex.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

constexpr double kStep_m = 0.0004;
// Tissue has the same colours in every theme.
constexpr QColor kTissue(206, 104, 98);
constexpr QColor kTissueLight(228, 142, 130);
constexpr QColor kTissueDeep(150, 62, 62);
constexpr QColor kTissueEdge(104, 34, 38);
constexpr QColor kBlanched(240, 204, 190);

QColor coverOf(const SceneColours& colours) {
    return colours.highContrast ? colours.background : colours.background.darker(106);
}

/// The pressing force of tool i as a fraction 0..1 of the limit; 0 under a cover.
double pressOf(const SceneSetup& setup, const ApexSurface& surface, const ToolView& tool) {
    if (!setup.cues.tool || !tool.present || surface.dentUnder(tool.p_WT).depth_m <= 0.0)
        return 0.0;
    return std::clamp(tool.force_N.norm() / std::max(0.1, setup.forceLimit_N), 0.0, 1.0);
}

} // namespace

FlatFrame FlatApex::frame() const {
    const double reach = m_parameters.workspaceRadius_m * 1e3 + 8.0;
    const double plane = m_parameters.planeHeight_m * 1e3;
    return {{-reach, -reach, 2.0 * reach, 2.0 * reach},
            {-reach, plane - 16.0, 2.0 * reach, 16.0 + m_parameters.radius_m * 1e3 + 46.0}};
}

double FlatApex::groundHeight_m(const SceneState& state, double x_m, double y_m) const {
    return ApexSurface::of(m_parameters, state).height_m(x_m, y_m);
}

void FlatApex::paint(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                     const SceneState& state) const {
    const ApexSurface surface = ApexSurface::of(m_parameters, state);
    if (panel.side() == FlatPanel::Side::above)
        paintAbove(painter, panel, setup, state, surface);
    else
        paintSide(painter, panel, setup, state, surface);
}

void FlatApex::paintAbove(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                          const SceneState& state, const ApexSurface& surface) const {
    const double field = panel.pixels(m_parameters.workspaceRadius_m * 1e3 + 5.0);
    const QPointF middle = panel.at(0.0, 0.0);
    painter.setPen(QPen(setup.colours.ink, 1.5 * panel.unit()));
    painter.setBrush(surface.shown ? QBrush(kTissue) : QBrush(coverOf(setup.colours)));
    painter.drawEllipse(middle, field, field);
    if (!surface.shown)
        return;
    const QPointF centre = panel.at(surface.ball.centre_m.x() * 1e3, surface.ball.centre_m.y() * 1e3);
    const double radius = panel.pixels(surface.ball.radius_m * 1e3);
    QRadialGradient round(centre, radius);
    round.setColorAt(0.0, kTissueLight.lighter(110));
    round.setColorAt(0.7, kTissue);
    round.setColorAt(1.0, kTissueDeep);
    painter.setBrush(round);
    painter.setPen(QPen(kTissueEdge, (setup.colours.highContrast ? 2.5 : 1.2) * panel.unit()));
    painter.drawEllipse(centre, radius, radius);
    painter.setPen(Qt::NoPen);
    for (const ToolView& tool : state.tool) {
        const double press = pressOf(setup, surface, tool);
        if (press <= 0.0)
            continue;
        const QPointF touched = panel.project(surface.dentUnder(tool.p_WT).p_WSurface);
        const double wide = panel.pixels(4.0 + 5.0 * press);
        QColor pale = kBlanched;
        pale.setAlphaF(float(0.35 + 0.65 * press));
        QRadialGradient spot(touched, wide);
        spot.setColorAt(0.0, pale);
        spot.setColorAt(0.55, pale);
        pale.setAlphaF(0.0F);
        spot.setColorAt(1.0, pale);
        painter.setBrush(spot);
        painter.drawEllipse(touched, wide, wide);
    }
}

std::vector<core::Vec2> FlatApex::profile(const ApexSurface& surface, const ToolView& tool) {
    Dent dent;
    double y_m = tool.present ? tool.p_WT.y() : surface.ball.centre_m.y();
    if (tool.present && !tool.drawnAtSurface) {
        dent = surface.dentUnder(tool.p_WT);
        if (dent.depth_m > 0.0)
            y_m = dent.p_WSurface.y();
    }
    std::vector<double> across;
    for (double x = -surface.fieldRadius_m; x <= surface.fieldRadius_m; x += kStep_m)
        across.push_back(x);
    if (dent.depth_m > 0.0) // the touched point itself, independent of the steps
        across.insert(std::upper_bound(across.begin(), across.end(), dent.p_WSurface.x()),
                      dent.p_WSurface.x());
    std::vector<core::Vec2> points;
    for (double x : across) {
        const bool touched = dent.depth_m > 0.0 && x == dent.p_WSurface.x();
        const core::Vec3 rest = touched ? dent.p_WSurface : core::Vec3(x, y_m, surface.height_m(x, y_m));
        const core::Vec3 p = dent.displaced(rest);
        points.emplace_back(p.x(), p.z());
    }
    return points;
}

void FlatApex::paintSide(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                         const SceneState& state, const ApexSurface& surface) const {
    const double plane = surface.ball.planeHeight_m * 1e3;
    if (surface.shown) { // the whole ball behind the section
        const QPointF centre = panel.at(surface.ball.centre_m.x() * 1e3, plane);
        const double radius = panel.pixels(surface.ball.radius_m * 1e3);
        QColor behind = kTissueLight;
        behind.setAlphaF(0.45F);
        painter.setPen(QPen(kTissueEdge, panel.unit(), Qt::DashLine));
        painter.setBrush(behind);
        painter.drawPie(QRectF(centre.x() - radius, centre.y() - radius, 2.0 * radius, 2.0 * radius), 0,
                        180 * 16);
    }
    ToolView cutter = state.tool[0];
    cutter.present = cutter.present && setup.cues.tool;
    QPolygonF edge;
    for (const core::Vec2& p : profile(surface, cutter))
        edge << panel.at(p.x() * 1e3, p.y() * 1e3);
    QPainterPath body;
    body.addPolygon(edge);
    body.lineTo(edge.last().x(), panel.plot().bottom());
    body.lineTo(edge.first().x(), panel.plot().bottom());
    body.closeSubpath();
    QLinearGradient depth(panel.at(0.0, plane + surface.ball.radius_m * 1e3),
                          QPointF(panel.at(0.0, 0.0).x(), panel.plot().bottom()));
    depth.setColorAt(0.0, kTissueLight);
    depth.setColorAt(1.0, kTissueDeep);
    painter.fillPath(body, surface.shown ? QBrush(depth) : QBrush(coverOf(setup.colours)));
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(surface.shown ? kTissueEdge : setup.colours.ink, 2.0 * panel.unit()));
    painter.drawPolyline(edge);
    const double press = surface.shown ? pressOf(setup, surface, state.tool[0]) : 0.0;
    if (press > 0.0) {
        const QPointF touched =
            panel.project(state.tool[0].drawnAtSurface ? state.tool[0].p_WProxy : state.tool[0].p_WT);
        QColor pale = kBlanched;
        pale.setAlphaF(float(0.35 + 0.65 * press));
        painter.save();
        painter.setClipPath(body, Qt::IntersectClip);
        painter.setPen(Qt::NoPen);
        painter.setBrush(pale);
        painter.drawEllipse(touched, panel.pixels(3.0 + 3.0 * press), panel.pixels(2.0 + 1.5 * press));
        painter.restore();
    }
}

std::vector<std::string> FlatApex::marks(const simulation::SphereApexParameters&, const MarkedScene& scene) {
    std::vector<std::string> marks = stageMarks(scene.setup, 1);
    if (scene.feedback)
        marks.push_back("apex_answer");
    return marks;
}

} // namespace chiron::scene3d
