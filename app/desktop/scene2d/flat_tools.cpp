// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene2d/flat_tools.h"

#include "desktop/scene3d/scene_marks.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <utility>

namespace chiron::scene3d {

namespace {

constexpr double kBlade_m = 0.020; // as in 3D
constexpr double kArrow_mm = 40.0; // at the limit, as in 3D
constexpr double kLongest = 1.75;
constexpr double kLeast_N = 0.02;
constexpr QColor kSteel(150, 156, 164);
constexpr QColor kCoat(44, 48, 54);

} // namespace

void FlatTools::paintTool(const ToolView& tool, const core::Quat& q_W, bool ghost) {
    const core::Vec3 tip = drawnTip(tool);
    const core::Vec3 along = q_W * core::Vec3::UnitZ();
    const QPointF from = m_panel.project(tip);
    const QPointF neck = m_panel.project(tip + 0.022 * along);
    const QPointF end = m_panel.project(tip + 0.30 * along);
    QColor coat = ghost ? m_setup.colours.ghost : kCoat;
    QColor steel = ghost ? m_setup.colours.ghost : kSteel;
    if (ghost) {
        coat.setAlphaF(0.45F);
        steel.setAlphaF(0.45F);
    }
    const double shaft = std::max(3.0 * m_panel.unit(), m_panel.pixels(4.7));
    QColor edge = m_setup.colours.ink; // so that the dark shaft stands out from a dark field as well
    edge.setAlphaF(m_setup.colours.highContrast ? 1.0F : 0.45F);
    if (!ghost) {
        m_painter.setPen(QPen(edge, shaft + (m_setup.colours.highContrast ? 3.0 : 2.0) * m_panel.unit(),
                              Qt::SolidLine, Qt::FlatCap));
        m_painter.drawLine(neck, end);
    }
    m_painter.setPen(QPen(coat, shaft, Qt::SolidLine, Qt::FlatCap));
    m_painter.drawLine(neck, end);
    paintBlades(tool, q_W, shaft, steel, ghost ? coat : edge);
    m_painter.setPen(QPen(m_setup.colours.ink, 1.5 * m_panel.unit(), ghost ? Qt::DotLine : Qt::SolidLine));
    m_painter.setBrush(steel);
    const double dot = 3.2 * m_panel.unit();
    m_painter.drawEllipse(from, dot, dot);
}

/// The two blades taper from the joint to their tips and diverge by the jaw's angle.
void FlatTools::paintBlades(const ToolView& tool, const core::Quat& q_W, double shaft, const QColor& steel,
                            const QColor& edge) {
    const core::Vec3 tip = drawnTip(tool);
    const QPointF neck = m_panel.project(tip + q_W * core::Vec3(0.0, 0.0, 0.022));
    m_painter.setPen(QPen(edge, m_panel.unit()));
    m_painter.setBrush(steel);
    for (const double side : {1.0, -1.0}) {
        const double angle = 0.5 * side * tool.jaw_rad;
        const core::Vec3 end(0.0, kBlade_m * std::sin(angle), kBlade_m * (1.0 - std::cos(angle)));
        const QPointF to = m_panel.project(tip + q_W * end);
        const QPointF way = neck - to;
        const double length = std::hypot(way.x(), way.y());
        if (length <= 1.0)
            continue;
        const QPointF beside = QPointF(-way.y(), way.x()) / length;
        QPolygonF blade;
        blade << to + 0.16 * shaft * beside << neck + 0.46 * shaft * beside << neck - 0.46 * shaft * beside
              << to - 0.16 * shaft * beside;
        m_painter.drawPolygon(blade);
    }
}

void FlatTools::paintRings(const ToolView& tool, const core::Quat& q_W, int index, bool active) {
    const core::Vec3 tip = drawnTip(tool);
    const double shaft = std::max(3.0 * m_panel.unit(), m_panel.pixels(4.7));
    for (int i = 0; i <= index; ++i) {
        const QPointF from = m_panel.project(tip + q_W * core::Vec3(0.0, 0.0, 0.032 + 0.0065 * i));
        const QPointF to = m_panel.project(tip + q_W * core::Vec3(0.0, 0.0, 0.036 + 0.0065 * i));
        m_painter.setPen(QPen(ringColour(index), shaft + 2.0 * m_panel.unit(), Qt::SolidLine, Qt::FlatCap));
        m_painter.drawLine(from, to);
    }
    if (!active)
        return;
    const double half = 8.0 * m_panel.unit();
    const QPointF at = m_panel.project(tip);
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(QPen(m_setup.colours.background, 4.0 * m_panel.unit()));
    m_painter.drawRect(QRectF(at.x() - half, at.y() - half, 2.0 * half, 2.0 * half));
    m_painter.setPen(QPen(m_setup.colours.ink, 2.0 * m_panel.unit()));
    m_painter.drawRect(QRectF(at.x() - half, at.y() - half, 2.0 * half, 2.0 * half));
}

void FlatTools::paintAcross(const QPointF& middle, const QPointF& along, double half_mm, double wide,
                            const QColor& colour) {
    const double length = std::hypot(along.x(), along.y());
    const QPointF beside = length > 1e-6 ? QPointF(-along.y(), along.x()) / length : QPointF(1.0, 0.0);
    m_painter.setPen(QPen(colour, wide * m_panel.unit(), Qt::SolidLine, Qt::FlatCap));
    m_painter.drawLine(middle - m_panel.pixels(half_mm) * beside, middle + m_panel.pixels(half_mm) * beside);
}

void FlatTools::paintArrow(const ToolView& tool) {
    const double force_N = tool.force_N.norm();
    if (force_N <= kLeast_N)
        return;
    const double share = force_N / std::max(0.1, m_setup.forceLimit_N);
    const core::Vec3 tip = drawnTip(tool);
    const core::Vec3 full = kArrow_mm * 1e-3 * tool.force_N / force_N;
    const QPointF from = m_panel.project(tip);
    const QPointF along = m_panel.project(tip + std::min(share, kLongest) * full) - from;
    m_painter.setPen(QPen(m_setup.colours.ink, m_panel.unit(), Qt::DotLine));
    m_painter.drawLine(from, m_panel.project(tip + full));
    // Drawn first wider in the background's colour, so that the arrow stands out from tissue of a similar
    // colour.
    paintArrowShape(from, along, share > 1.0, 2.5, m_setup.colours.background);
    paintArrowShape(from, along, share > 1.0, 0.0,
                    share > 1.0 ? m_setup.colours.over : m_setup.colours.arrow);
    const QPointF limit = m_panel.project(tip + full);
    paintAcross(limit, along, 5.4, 4.5, m_setup.colours.background);
    paintAcross(limit, along, 5.0, 2.5, m_setup.colours.ink);
}

void FlatTools::paintArrowShape(const QPointF& from, const QPointF& along, bool over, double halo,
                                const QColor& colour) {
    const double length = std::hypot(along.x(), along.y());
    if (length < 1.0)
        return;
    const double u = m_panel.unit();
    const QPointF ahead = along / length;
    const QPointF beside(-ahead.y(), ahead.x());
    const double wide = (over ? 6.0 : 3.5) + 2.0 * halo;
    const double head = std::min(length, (over ? 17.0 : 13.0) * u);
    const QPointF to = from + along;
    m_painter.setPen(QPen(colour, wide * u, Qt::SolidLine, Qt::FlatCap));
    m_painter.drawLine(from, to - 0.9 * head * ahead);
    QPolygonF point;
    point << to << to - head * ahead + 0.5 * head * beside << to - head * ahead - 0.5 * head * beside;
    m_painter.setPen(halo > 0.0 ? QPen(colour, 2.0 * halo * u) : QPen(Qt::NoPen));
    m_painter.setBrush(colour);
    m_painter.drawPolygon(point);
    for (int i = 0; over && i < 3; ++i)
        paintAcross(from + (0.25 + 0.18 * i) * along, along, 2.8, 2.5 + 2.0 * halo, colour);
}

void FlatTools::paintDropLine(const core::Vec3& from_W, double ground_m) {
    if (m_panel.side() != FlatPanel::Side::side || from_W.z() - ground_m < 0.0015)
        return;
    const QPointF foot = m_panel.project({from_W.x(), from_W.y(), ground_m});
    m_painter.setPen(QPen(m_setup.colours.ink, 1.2 * m_panel.unit(), Qt::DashLine));
    m_painter.drawLine(m_panel.project(from_W), foot);
    m_painter.setPen(QPen(m_setup.colours.ink, 2.0 * m_panel.unit()));
    m_painter.drawLine(foot - QPointF(m_panel.pixels(3.0), 0.0), foot + QPointF(m_panel.pixels(3.0), 0.0));
}

void FlatTools::paintPin(const core::Vec3& p_W) {
    const QPointF foot = m_panel.project(p_W);
    const double u = m_panel.unit();
    m_painter.setPen(QPen(m_setup.colours.ink, 2.0 * u));
    m_painter.setBrush(m_setup.colours.arrow);
    if (m_panel.side() == FlatPanel::Side::above) { // a diamond, unlike any tip
        QPolygonF diamond;
        diamond << foot + QPointF(0, -8 * u) << foot + QPointF(8 * u, 0) << foot + QPointF(0, 8 * u)
                << foot + QPointF(-8 * u, 0);
        m_painter.drawPolygon(diamond);
        return;
    }
    m_painter.drawLine(foot, foot - QPointF(0, 20 * u));
    m_painter.drawEllipse(foot - QPointF(0, 24 * u), 5.5 * u, 5.5 * u);
}

void FlatTools::paintAnswer(const core::Vec3& p_W) {
    const QPointF at = m_panel.project(p_W);
    m_painter.setBrush(Qt::NoBrush);
    for (const double radius_mm : kAnswerRings_mm)
        for (const auto& [colour, wide] :
             {std::pair{m_setup.colours.background, 4.5}, {m_setup.colours.ink, 2.0}}) {
            m_painter.setPen(QPen(colour, wide * m_panel.unit()));
            m_painter.drawEllipse(at, m_panel.pixels(radius_mm), m_panel.pixels(radius_mm));
        }
}

void FlatTools::paintYields(const SceneState& state) {
    const double half = 7.0 * m_panel.unit();
    for (const core::Vec3& p_W : state.p_WYielded) {
        const QPointF at = m_panel.project(p_W);
        for (const auto& [colour, wide] :
             {std::pair{m_setup.colours.background, 6.5}, {m_setup.colours.over, 3.5}}) {
            m_painter.setPen(QPen(colour, wide * m_panel.unit(), Qt::SolidLine, Qt::RoundCap));
            m_painter.drawLine(at - QPointF(half, half), at + QPointF(half, half));
            m_painter.drawLine(at - QPointF(half, -half), at + QPointF(half, -half));
        }
    }
}

} // namespace chiron::scene3d
