// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/flat_profile.h"

#include "desktop/scene2d/flat_tools.h"
#include "desktop/scene3d/drawn_tool.h"
#include "simulation/geometry/urethra/urethra_wall.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

constexpr int kSections = 140;
constexpr double kAnchored_m = 0.015; // length of canal before the neck, as in the overview in 3D
constexpr QColor kTissue(206, 104, 98);
constexpr QColor kEdge(104, 34, 38);
constexpr QColor kBladder(228, 168, 148);
constexpr QColor kSteel(128, 134, 142);

double smooth(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

} // namespace

FlatProfile::Edges FlatProfile::edges(const ToolView& tool) const {
    const simulation::UrethraInsertionParameters& p = m_drawing.parameters();
    const simulation::UrethraWall wall(p.anatomy, p.endoscope);
    const simulation::UrethraDeformation now = m_drawing.deformationOf(tool);
    const double length = m_drawing.centreline().length_m();
    const core::Vec3 tip = m_drawing.tip_A(tool);
    const core::Vec3 ahead = -m_drawing.axes_A(tool).col(2);
    Edges edges;
    for (int i = 0; i <= kSections; ++i) {
        const double s = length * i / kSections;
        const simulation::CentrelinePoint at = m_drawing.centreline().at(s);
        const double moved = now.inside ? wall.following(s, now.tip_s_m) : 0.0;
        const double radius = now.inside ? wall.openedRadius_m(s, now.tip_s_m) : wall.radius_m(s);
        core::Vec3 middle = at.p_A + moved * (now.ex_m * core::Vec3::UnitX() + now.en_m * at.n_A);
        core::Vec3 along = at.t_A;
        if (now.inside && s < now.tip_s_m) {
            const double free = 1.0 - smooth((s - (length - kAnchored_m)) / kAnchored_m);
            middle += free * (tip - (now.tip_s_m - s) * ahead - middle);
            along += free * (ahead - along);
        }
        core::Vec3 aside(0.0, along.z(), -along.y()); // in the plane of symmetry
        aside /= std::max(1e-9, aside.norm());
        edges.low.push_back(p.pose.pointToW(middle - radius * aside));
        edges.high.push_back(p.pose.pointToW(middle + radius * aside));
    }
    return edges;
}

QRectF FlatProfile::range_mm() const {
    const simulation::UrethraInsertionParameters& p = m_drawing.parameters();
    QRectF range;
    const auto add = [&](const core::Vec3& p_A, double around_m) {
        const core::Vec3 q = p.pose.pointToW(p_A) * 1e3;
        const double r = around_m * 1e3;
        range = range.united(QRectF(q.y() - r, q.z() - r, 2.0 * r, 2.0 * r));
    };
    add({0.0, 0.0, -0.030}, 0.010);
    for (int i = 0; i <= 8; ++i)
        add(m_drawing.centreline().atZ(p.anatomy.zEnd_m * i / 8.0).p_A, 0.010);
    add(m_drawing.bladderCentre_A(), p.anatomy.bladderRadius_m + 0.004);
    return range;
}

void FlatProfile::paintTissue(QPainter& painter, const FlatPanel& panel, const ToolView& tool) const {
    const simulation::UrethraInsertionParameters& p = m_drawing.parameters();
    const Edges edges = this->edges(tool);
    QPolygonF canal;
    for (const core::Vec3& q : edges.low)
        canal << panel.project(q);
    for (auto q = edges.high.rbegin(); q != edges.high.rend(); ++q)
        canal << panel.project(*q);
    const double wide = (m_setup.colours.highContrast ? 2.5 : 1.4) * panel.unit();
    const double radius = panel.pixels(p.anatomy.bladderRadius_m * 1e3);
    painter.setPen(QPen(kEdge, wide));
    painter.setBrush(kBladder);
    painter.drawEllipse(panel.project(p.pose.pointToW(m_drawing.bladderCentre_A())), radius, radius);
    painter.setBrush(kTissue);
    painter.drawPolygon(canal);
}

void FlatProfile::paintShaft(QPainter& painter, const FlatPanel& panel, const ToolView& tool,
                             bool ghost) const {
    const simulation::UrethraInsertionParameters& p = m_drawing.parameters();
    const core::Vec3 back = p.pose.vectorToW(m_drawing.axes_A(tool).col(2));
    const core::Vec3 tip = drawnTip(tool);
    const double wide = std::max(3.0 * panel.unit(), panel.pixels(2.0 * p.endoscope.radius_m * 1e3));
    QColor colour = ghost ? m_setup.colours.ghost : kSteel;
    if (ghost)
        colour.setAlphaF(0.45F);
    else {
        painter.setPen(QPen(m_setup.colours.ink, wide + 2.0 * panel.unit(), Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(panel.project(tip), panel.project(tip + 0.25 * back));
    }
    painter.setPen(QPen(colour, wide, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(panel.project(tip), panel.project(tip + 0.25 * back));
}

void FlatProfile::paint(QPainter& painter, const QRectF& room, const SceneState& state) const {
    FlatPanel panel(FlatPanel::Side::profile, range_mm(), m_setup);
    const QSizeF frame = panel.cardSize(0.0);
    const QRectF range = panel.range_mm();
    const double scale = std::max(0.2, std::min((room.width() - frame.width()) / range.width(),
                                                (room.height() - frame.height()) / range.height()));
    const QSizeF card = panel.cardSize(scale);
    panel.place(room.center() - QPointF(0.5 * card.width(), 0.5 * card.height()), scale);
    const auto words = [](const char* text) {
        return QCoreApplication::translate("chiron::scene3d::FlatCanvas", text);
    };
    panel.paintCard(painter, words("From the side"), words("y (mm)"), words("z (mm)"));
    painter.save();
    painter.setClipRect(panel.plot());
    ToolView tool = state.tool[0];
    ToolView shown = tool;
    shown.present = tool.present && m_setup.cues.tool;
    paintTissue(painter, panel, shown);
    if (state.ghost.present)
        paintShaft(painter, panel, state.ghost, true);
    if (shown.present)
        paintShaft(painter, panel, shown, false);
    FlatTools tools(painter, panel, m_setup);
    if (m_setup.cues.arrow && tool.present)
        tools.paintArrow(tool);
    tools.paintYields(state);
    painter.restore();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_setup.colours.ink, m_setup.scale));
    painter.drawRect(panel.plot());
}

} // namespace chiron::scene3d
