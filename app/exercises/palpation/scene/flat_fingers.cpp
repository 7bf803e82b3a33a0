// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/scene/flat_fingers.h"

#include "app/exercises/palpation/scene/finger_mesh.h"
#include "app/exercises/palpation/scene/finger_pose.h"
#include "desktop/scene3d/drawn_tool.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

constexpr double kWide_mm = 16.0;
const QColor kRightGlove(58, 116, 190);
const QColor kLeftGlove(142, 104, 186);

struct Words {
    Q_DECLARE_TR_FUNCTIONS(chiron::scene3d::FlatFingers)
};

} // namespace

/// The position in this picture of a point in the finger's own plane (y towards the tip, z up; mm).
QPointF FlatFingers::along(const ToolView& tool, std::size_t index, double y_mm, double z_mm) const {
    const core::Quat held = tool.q_WT.norm() > 0.5 ? tool.q_WT.normalized() : core::Quat::Identity();
    const core::Quat q =
        held * core::Quat(Eigen::AngleAxisd(fingerYaw_rad(m_setup, index), core::Vec3::UnitZ()));
    return m_panel.project(drawnTip(tool) + q * core::Vec3(0.0, 1e-3 * y_mm, 1e-3 * z_mm));
}

void FlatFingers::paintOutline(const ToolView& tool, std::size_t index, const QColor& glove,
                               bool ghost) const {
    QPainterPath line(along(tool, index, 2.0, 7.7));
    line.lineTo(along(tool, index, -11.0, 11.2));
    line.lineTo(along(tool, index, -34.0, 24.6));
    line.lineTo(along(tool, index, -53.0, 38.4));
    line.lineTo(along(tool, index, -74.0, 47.0));
    QPainterPathStroker stroker;
    stroker.setWidth(m_panel.pixels(kWide_mm));
    stroker.setCapStyle(Qt::RoundCap);
    stroker.setJoinStyle(Qt::RoundJoin);
    QPainterPath finger = stroker.createStroke(line).simplified();
    if (!ghost && static_cast<int>(index) %
                          std::max(1, m_setup.parameters.as<simulation::PalpationParameters>().fingers) ==
                      0)
        finger = finger.united(backOfHand(tool, index));
    QColor fill = glove;
    if (ghost)
        fill.setAlphaF(0.22F);
    m_painter.setBrush(fill);
    m_painter.setPen(QPen(ghost ? m_setup.colours.ghost : m_setup.colours.ink,
                          (m_setup.colours.highContrast ? 2.5 : 1.5) * m_panel.unit(),
                          ghost ? Qt::DashLine : Qt::SolidLine));
    m_painter.drawPath(finger);
}

/// The outline of the hand of hand_mesh.h, as seen in this picture.
QPainterPath FlatFingers::backOfHand(const ToolView& tool, std::size_t index) const {
    const double side = isLeftHand(m_setup, index) ? -1.0 : 1.0;
    const core::Quat held = tool.q_WT.norm() > 0.5 ? tool.q_WT.normalized() : core::Quat::Identity();
    const core::Quat q =
        held * core::Quat(Eigen::AngleAxisd(fingerYaw_rad(m_setup, index), core::Vec3::UnitZ()));
    const auto at = [&](double x_mm, double y_mm, double z_mm) {
        return m_panel.project(drawnTip(tool) + q * core::Vec3(1e-3 * side * x_mm, 1e-3 * y_mm, 1e-3 * z_mm));
    };
    const auto rope = [&](std::initializer_list<QPointF> points, double wide_mm) {
        QPainterPath middle(*points.begin());
        for (const QPointF& point : points)
            middle.lineTo(point);
        QPainterPathStroker stroker;
        stroker.setWidth(m_panel.pixels(wide_mm));
        stroker.setCapStyle(Qt::RoundCap);
        stroker.setJoinStyle(Qt::RoundJoin);
        return stroker.createStroke(middle).simplified();
    };
    QPainterPath hand = rope({at(24, -90, 56), at(26, -140, 74)}, 62.0);                   // back of the hand
    hand = hand.united(rope({at(24, -150, 78), at(24, -226, 106)}, 58.0));                 // wrist and cuff
    hand = hand.united(rope({at(6, -126, 60), at(-22, -72, 34), at(-20, -40, 28)}, 20.0)); // thumb
    const int used = m_setup.parameters.as<simulation::PalpationParameters>().fingers;
    for (int i = used; i < 4; ++i)
        hand = hand.united(rope({at(19.0 * i, -76.0 - 3.0 * i, 46), at(19.0 * i, -42.0 - 4.0 * i, 34)},
                                18.0)); // folded fingers
    return hand;
}

void FlatFingers::paintBands(const ToolView& tool, std::size_t index, bool active) const {
    const double u = m_panel.unit();
    for (std::size_t i = 0; i <= index; ++i) {
        const QPointF a = along(tool, index, -17.0 - 5.0 * double(i), 13.5 + 3.0 * double(i));
        const QPointF b = along(tool, index, -19.5 - 5.0 * double(i), 15.0 + 3.0 * double(i));
        m_painter.setPen(
            QPen(m_setup.colours.ink, m_panel.pixels(kWide_mm) + 2.0 * u, Qt::SolidLine, Qt::FlatCap));
        m_painter.drawLine(a, b);
        m_painter.setPen(
            QPen(ringColour(int(index)), m_panel.pixels(kWide_mm) - u, Qt::SolidLine, Qt::FlatCap));
        m_painter.drawLine(a, b);
    }
    if (!active)
        return;
    const QPointF at = m_panel.project(drawnTip(tool));
    const double half = m_panel.pixels(kPlatformRing_mm) + 5.0 * u;
    m_painter.setBrush(Qt::NoBrush);
    for (const auto& [colour, wide] :
         {std::pair{m_setup.colours.background, 4.0}, {m_setup.colours.ink, 2.0}}) {
        m_painter.setPen(QPen(colour, wide * u));
        m_painter.drawRect(QRectF(at - QPointF(half, half), QSizeF(2.0 * half, 2.0 * half)));
    }
}

void FlatFingers::paintDial(const SceneState& state, std::size_t index) const {
    const ToolView& tool = state.tool[index];
    const double u = m_panel.unit();
    const QPointF middle = m_panel.project(drawnTip(tool));
    const double radius = m_panel.pixels(kPlatformRing_mm);
    const FingerLean lean = fingerLean(state, index, m_surface.normalAt(drawnTip(tool).head<2>()));
    m_painter.setBrush(Qt::NoBrush);
    m_painter.setPen(QPen(m_setup.colours.background, 4.0 * u));
    m_painter.drawEllipse(middle, radius, radius);
    m_painter.setPen(
        QPen(lean.saturated ? m_setup.colours.over : m_setup.colours.ink, (lean.saturated ? 3.0 : 1.6) * u));
    m_painter.drawEllipse(middle, radius, radius);
    if (lean.saturated) // at its stop: a second rim
        m_painter.drawEllipse(middle, radius + 5.0 * u, radius + 5.0 * u);
    const QPointF way =
        m_panel.project(drawnTip(tool) + 1e-3 * core::Vec3(lean.toward.x(), lean.toward.y(), 0.0)) - middle;
    const double length = std::hypot(way.x(), way.y());
    if (length > 1e-9) {
        const QPointF tip = middle + radius * lean.angle_rad / kMostLean_rad / length * way;
        for (const auto& [colour, wide] :
             {std::pair{m_setup.colours.background, 7.0},
              {lean.saturated ? m_setup.colours.over : m_setup.colours.arrow, 4.0}}) {
            m_painter.setPen(QPen(colour, wide * u, Qt::SolidLine, Qt::RoundCap));
            m_painter.drawLine(middle, tip);
        }
    }
    m_painter.setPen(QPen(m_setup.colours.ink, 1.5 * u));
    m_painter.setBrush(m_setup.colours.background);
    m_painter.drawEllipse(middle, 3.0 * u, 3.0 * u);
    if (length <= 1e-9)
        return;
    // The force arrow points in the same direction as the needle, so the number of the angle is on the
    // opposite side.
    const QString words = Words::tr("%1°").arg(QLocale().toString(
        state.exercise.of<simulation::PalpationCues>().lean_rad[index] * 180.0 / core::kPi, 'f', 0));
    const QPointF place = middle - (radius + 18.0 * u) / length * way;
    const QRectF box(place - QPointF(16.0, 9.0) * u, QSizeF(32.0, 18.0) * u);
    m_painter.setPen(Qt::NoPen);
    m_painter.drawRoundedRect(box, 3.0 * u, 3.0 * u);
    m_painter.setPen(m_setup.colours.ink);
    m_painter.setFont(m_panel.font(12, true));
    m_painter.drawText(box, Qt::AlignCenter, words);
}

void FlatFingers::paintPlatform(const SceneState& state, std::size_t index) const {
    const ToolView& tool = state.tool[index];
    const FingerLean lean = fingerLean(state, index, m_surface.normalAt(drawnTip(tool).head<2>()));
    const double tilt = lean.angle_rad * lean.toward.x(); // as seen in this picture
    const core::Vec3 middle = drawnTip(tool) + core::Vec3(0.0, 0.0, 1e-3 * kPlatformHeight_mm);
    const core::Vec3 half = 1e-3 * kPlatformRing_mm * core::Vec3(std::cos(tilt), 0.0, -std::sin(tilt));
    for (const auto& [colour, wide] : {std::pair{m_setup.colours.background, 6.5},
                                       {lean.saturated ? m_setup.colours.over : m_setup.colours.ink, 3.5}}) {
        m_painter.setPen(QPen(colour, wide * m_panel.unit(), Qt::SolidLine, Qt::RoundCap));
        m_painter.drawLine(m_panel.project(middle - half), m_panel.project(middle + half));
    }
}

/// The two blades of the hand's jaw, from their joint to their tips.
void FlatFingers::paintBlades(const ToolView& tool, std::size_t index) const {
    if (!hasJaw(m_setup, index) || !(tool.jaw_rad > kDrawnJaw_rad))
        return;
    const core::Quat q = tool.q_WT.norm() > 0.5 ? tool.q_WT.normalized() : core::Quat::Identity();
    const double length = m_setup.parameters.as<simulation::PalpationParameters>().pinch->jawLength_m;
    const core::Vec3 joint(0.0, 0.0, length);
    for (const double side : {0.5, -0.5}) {
        const core::Vec3 tip =
            joint + length * core::Vec3(std::sin(side * tool.jaw_rad), 0.0, -std::cos(side * tool.jaw_rad));
        for (const auto& [colour, wide] :
             {std::pair{m_setup.colours.background, 6.0}, {m_setup.colours.ink, 3.0}}) {
            m_painter.setPen(QPen(colour, wide * m_panel.unit(), Qt::SolidLine, Qt::RoundCap));
            m_painter.drawLine(m_panel.project(drawnTip(tool) + q * joint),
                               m_panel.project(drawnTip(tool) + q * tip));
        }
    }
}

/// Draws the depth between the surface at rest and the pad, beside the finger.
void FlatFingers::paintDepth(const SceneState& state, std::size_t index) const {
    const auto& cues = state.exercise.of<simulation::PalpationCues>();
    const double depth_mm = 1e3 * cues.depth_m[index];
    if (!cues.present || !(depth_mm > 0.05))
        return;
    const ToolView& tool = state.tool[index];
    const double u = m_panel.unit();
    const core::Vec3 rest = m_surface.nearest(tool.p_WT, tool.p_WT.head<2>()).p_W;
    // With two hands on their outer side, with one hand beside the tip.
    const bool left = isLeftHand(m_setup, index) == (toolsOf(state) < 2);
    const double beside = (left ? 1.0 : -1.0) * m_panel.pixels(kPlatformRing_mm + 4.0);
    const QPointF top = m_panel.project(rest) + QPointF(beside, 0.0);
    const QPointF foot = top + QPointF(0.0, m_panel.pixels(depth_mm));
    for (const auto& [colour, wide] :
         {std::pair{m_setup.colours.background, 9.0}, {m_setup.colours.arrow, 5.0}}) {
        m_painter.setPen(QPen(colour, wide * u, Qt::SolidLine, Qt::FlatCap));
        m_painter.drawLine(top, foot);
    }
    m_painter.setPen(QPen(m_setup.colours.ink, 1.5 * u));
    for (const QPointF& end : {top, foot})
        m_painter.drawLine(end - QPointF(5.0 * u, 0.0), end + QPointF(5.0 * u, 0.0));
    const QString words = Words::tr("%1 mm").arg(QLocale().toString(depth_mm, 'f', 1));
    m_painter.setFont(m_panel.font(12, true));
    const double wide = m_painter.fontMetrics().horizontalAdvance(words) + 8.0 * u;
    const QRectF box(beside < 0.0 ? top.x() - 8.0 * u - wide : top.x() + 8.0 * u, foot.y() + 2.0 * u, wide,
                     18.0 * u);
    m_painter.setPen(Qt::NoPen);
    m_painter.setBrush(m_setup.colours.background);
    m_painter.drawRoundedRect(box, 3.0 * u, 3.0 * u);
    m_painter.setPen(m_setup.colours.ink);
    m_painter.drawText(box, Qt::AlignCenter, words);
}

void FlatFingers::paint(const SceneState& state) const {
    const bool several = toolsOf(state) > 1;
    for (std::size_t i = 0; i < state.tool.size(); ++i) {
        const ToolView& tool = state.tool[i];
        if (!tool.present)
            continue;
        QColor glove = isLeftHand(m_setup, i) ? kLeftGlove : kRightGlove;
        glove.setAlphaF(float(gloveOpacity(m_setup, state, m_surface, i)));
        paintOutline(tool, i, glove, false);
        if (several)
            paintBands(tool, i,
                       state.activeTool == static_cast<int>(i) && m_panel.side() == FlatPanel::Side::above);
        paintBlades(tool, i);
        if (m_panel.side() == FlatPanel::Side::above) {
            paintDial(state, i);
            continue;
        }
        paintPlatform(state, i);
        paintDepth(state, i);
    }
}

void FlatFingers::paintGhost(const ToolView& ghost) const {
    if (ghost.present)
        paintOutline(ghost, 0, m_setup.colours.ghost, true);
}

} // namespace chiron::scene3d
