// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/flat_scope_picture.h"

#include "app/exercises/urethra_insertion/scene/notice_painter.h"
#include "core/units.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "simulation/geometry/urethra/urethra_wall.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

constexpr double kStep_m = 0.0015;
constexpr double kFarthest_m = 0.060;
constexpr int kCorners = 40;
constexpr QColor kWall(222, 140, 128);
constexpr QColor kBladder(206, 138, 118);
constexpr QColor kOrifice(120, 26, 28);

QColor lit(const QColor& colour, double share) {
    const auto part = [&](int value) { return int(std::clamp(share, 0.0, 1.0) * value); };
    return {part(colour.red()), part(colour.green()), part(colour.blue())};
}

/// Projects a point of A into the picture; returns false for points behind or beside the camera.
struct Eye {
    core::Vec3 tip_A;
    core::Mat3 axes_A;
    double wide;

    bool see(const core::Vec3& p_A, QPointF& at) const {
        const core::Vec3 q = axes_A.transpose() * (p_A - tip_A);
        const double ahead = -q.z();
        if (!(ahead > 2e-4) || q.head<2>().norm() > 12.0 * ahead)
            return false;
        at = QPointF(q.x() / (ahead * wide), q.y() / (ahead * wide));
        return true;
    }
};

Eye eyeOf(const UrethraDrawing& drawing, const ToolView& tool) {
    return {drawing.tip_A(tool), drawing.axes_A(tool),
            std::tan(0.5 * drawing.parameters().endoscope.fieldOfView_rad)};
}

} // namespace

QPainterPath FlatScopePicture::section(const ToolView& tool, double s_m) const {
    const simulation::UrethraInsertionParameters& p = m_drawing.parameters();
    const simulation::UrethraWall wall(p.anatomy, p.endoscope);
    const simulation::UrethraDeformation now = m_drawing.deformationOf(tool);
    const simulation::CentrelinePoint at = m_drawing.centreline().at(s_m);
    const double moved = now.inside ? wall.following(s_m, now.tip_s_m) : 0.0;
    const double radius = now.inside ? wall.openedRadius_m(s_m, now.tip_s_m) : wall.radius_m(s_m);
    const core::Vec3 middle = at.p_A + moved * (now.ex_m * core::Vec3::UnitX() + now.en_m * at.n_A);
    const Eye eye = eyeOf(m_drawing, tool);
    QPolygonF corners;
    for (int i = 0; i < kCorners; ++i) {
        const double turn = 2.0 * core::kPi * i / kCorners;
        QPointF seen;
        if (!eye.see(middle + radius * (std::cos(turn) * core::Vec3::UnitX() + std::sin(turn) * at.n_A),
                     seen))
            return {};
        corners << seen;
    }
    QPainterPath path;
    path.addPolygon(corners);
    path.closeSubpath();
    return path;
}

void FlatScopePicture::paintCanal(QPainter& painter, const ToolView& tool) const {
    const double tip = m_drawing.centreline().foot(m_drawing.tip_A(tool)).at.s_m;
    const double end = std::min(m_drawing.centreline().length_m(), std::max(0.0, tip) + kFarthest_m);
    painter.fillRect(QRectF(-1.0, -1.0, 2.0, 2.0), lit(kWall, 1.0));
    QPainterPath open; // the area visible through all sections so far
    open.addRect(QRectF(-1.0, -1.0, 2.0, 2.0));
    for (double s = std::max(0.0, tip + kStep_m); s <= end && !open.isEmpty(); s += kStep_m) {
        const QPainterPath outline = section(tool, s);
        if (outline.isEmpty())
            continue;
        open = open.intersected(outline);
        const double near = UrethraDrawing::kNear_m / (UrethraDrawing::kNear_m + std::max(0.0, s - tip));
        painter.fillPath(open, lit(kWall, near * near * 1.5));
    }
    if (end >= m_drawing.centreline().length_m() - 1e-9)
        painter.fillPath(open, lit(kBladder, 0.35)); // the bladder behind the neck
    else
        painter.fillPath(open, Qt::black);
}

void FlatScopePicture::paintBladder(QPainter& painter, const SceneState& state) const {
    const Eye eye = eyeOf(m_drawing, state.tool[0]);
    painter.fillRect(QRectF(-1.0, -1.0, 2.0, 2.0), kBladder);
    const auto& landmarks = m_drawing.parameters().landmarks;
    for (std::size_t i = 0; i < landmarks.size(); ++i) {
        const core::Vec3 place = m_drawing.landmark_A(landmarks[i]);
        QPointF at;
        if (!eye.see(place, at))
            continue;
        const double size = 0.0042 / ((place - eye.tip_A).norm() * eye.wide);
        painter.setPen(Qt::NoPen);
        painter.setBrush(kOrifice);
        if (landmarks[i].id.find("ureter") != std::string::npos)
            painter.drawEllipse(at, 0.6 * size, 0.2 * size);
        if (!m_setup.cues.guidance || !state.exercise.of<simulation::EndoscopeCues>().guided)
            continue;
        QPainterPath ring;
        ring.addEllipse(at, size, size);
        if (i < 32 && (state.exercise.of<simulation::EndoscopeCues>().landmarksSeen >> i & 1U) != 0) {
            ring.moveTo(at + QPointF(-0.4 * size, 0.0));
            ring.lineTo(at + QPointF(-0.1 * size, -0.35 * size));
            ring.lineTo(at + QPointF(0.45 * size, 0.4 * size));
        }
        stroke(painter, ring, Qt::white, 0.012);
    }
}

void FlatScopePicture::stroke(QPainter& painter, const QPainterPath& path, const QColor& colour,
                              double wide) const {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::black, wide + 0.014));
    painter.drawPath(path);
    painter.setPen(QPen(colour, wide));
    painter.drawPath(path);
}

void FlatScopePicture::paintMarks(QPainter& painter, const ScopeMarks& marks) const {
    const QColor guide = m_setup.colours.highContrast ? QColor(255, 255, 0) : QColor(140, 240, 255);
    if (marks.guided) {
        const QPointF at(marks.lumen.x(), marks.lumen.y());
        const QPointF target(marks.target.x(), marks.target.y());
        QPainterPath path;
        path.addEllipse(target, 0.02, 0.02);
        path.moveTo(target);
        path.lineTo(at);
        const QPointF way = (at - target) / std::max(1e-6, (marks.lumen - marks.target).norm());
        const QPointF aside(-way.y(), way.x());
        if (marks.beyond) { // an arrowhead at the rim
            path.moveTo(at + 0.06 * aside);
            path.lineTo(at + 0.11 * way);
            path.lineTo(at - 0.06 * aside);
        } else {
            path.addEllipse(at, 0.085, 0.085);
        }
        if (marks.aligned)
            path.addEllipse(at, 0.05, 0.05);
        stroke(painter, path, guide, 0.014);
    }
    if (marks.dwell > 0.0) {
        QPainterPath arc;
        const QRectF round(-0.155, -0.155, 0.31, 0.31);
        arc.arcMoveTo(round, -90.0); // y points up here, so this is the top
        arc.arcTo(round, -90.0, 360.0 * marks.dwell);
        stroke(painter, arc, guide, 0.028);
    }
    if (marks.force)
        paintForce(painter, marks);
}

void FlatScopePicture::paintForce(QPainter& painter, const ScopeMarks& marks) const {
    const QPointF way(marks.forceWay.x(), marks.forceWay.y());
    const QPointF aside(-way.y(), way.x());
    const double length = 0.24 * std::min(marks.forceShare, ScopeMarks::kLongest);
    const QPointF from = 0.56 * way;
    const QPointF to = from + length * way;
    const double head = std::min(0.09, 0.6 * length);
    QPainterPath path;
    path.moveTo(from);
    path.lineTo(to);
    path.moveTo(to - head * (way - 0.6 * aside));
    path.lineTo(to);
    path.lineTo(to - head * (way + 0.6 * aside));
    for (int i = 1; marks.over && i <= 3; ++i) { // crossbars on an arrow over the limit
        const QPointF rung = from + 0.2 * i * length * way;
        path.moveTo(rung - 0.04 * aside);
        path.lineTo(rung + 0.04 * aside);
    }
    const QPointF limit = from + 0.24 * way;
    path.moveTo(limit - 0.055 * aside);
    path.lineTo(limit + 0.055 * aside);
    stroke(painter, path, marks.over ? QColor(255, 226, 60) : QColor(Qt::white), marks.over ? 0.026 : 0.016);
}

void FlatScopePicture::paint(QPainter& painter, const QRectF& square, const SceneState& state) const {
    const ScopeMarks marks = ScopeMarks::of(m_setup, m_drawing, state);
    if (!m_setup.cues.object || !state.objectShown) {
        const double side = square.width();
        NoticePainter(m_setup).paint(
            painter, square.adjusted(0.12 * side, 0.3 * side, -0.12 * side, -0.3 * side), 1.0);
        return;
    }
    painter.save();
    painter.translate(square.center());
    painter.scale(0.5 * square.width(), -0.5 * square.height());
    QPainterPath round;
    round.addEllipse(QPointF(0, 0), 0.99, 0.99);
    painter.setClipPath(round);
    if (marks.pictureShown) {
        const double tip = m_drawing.centreline().foot(m_drawing.tip_A(state.tool[0])).at.s_m;
        if (tip < m_drawing.centreline().length_m())
            paintCanal(painter, state.tool[0]);
        else
            paintBladder(painter, state);
    }
    paintMarks(painter, marks);
    painter.restore();
}

} // namespace chiron::scene3d
