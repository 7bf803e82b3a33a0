// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/elastic_tube/scene/flat_tube.h"

#include "app/exercises/elastic_tube/scene/fold_sheet.h"
#include "app/exercises/elastic_tube/scene/mark_ring.h"
#include "app/exercises/elastic_tube/scene/tube_curve.h"
#include "desktop/scene2d/laparoscopy/flat_floor.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

QColor mixed(const QColor& a, const QColor& b, double t) {
    return QColor::fromRgbF(float(a.redF() + t * (b.redF() - a.redF())),
                            float(a.greenF() + t * (b.greenF() - a.greenF())),
                            float(a.blueF() + t * (b.blueF() - a.blueF())));
}

void paintPiece(QPainter& painter, const FlatPanel& panel, const TubePiece& piece, double more,
                const QColor* edge) {
    for (std::size_t k = 1; k < piece.rings.size(); ++k) {
        const TubeRing& a = piece.rings[k - 1];
        const TubeRing& b = piece.rings[k];
        const double wide = panel.pixels(1e3 * (a.radius_m + b.radius_m)) + more;
        const bool torn = (k == 1 && piece.first == SweepEnd::ragged) ||
                          (k + 1 == piece.rings.size() && piece.last == SweepEnd::ragged);
        const QColor own =
            torn ? flat_tissue::kDeep : mixed(QColor(238, 168, 158), flat_tissue::kBlanched, b.pale);
        painter.setPen(
            QPen(edge ? *edge : own, std::max(2.0, wide), Qt::SolidLine, torn ? Qt::FlatCap : Qt::RoundCap));
        painter.drawLine(panel.project(a.p_W), panel.project(b.p_W));
    }
}

/// Draws the fold's outline, translucent so that the tube under it stays visible; its edge is a line with the
/// position to grip.
void paintFold(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
               const core::LaparoscopyCues& cues) {
    const FoldSheet sheet = FoldSheet::of(cues);
    if (sheet.rows.empty())
        return;
    const auto outlineOf = [&](std::size_t from, std::size_t to) {
        QPolygonF outline;
        for (std::size_t r = from; r <= to; ++r)
            outline << panel.project(sheet.rows[r].front());
        for (const core::Vec3& p : sheet.rows[to])
            outline << panel.project(p);
        for (std::size_t r = to + 1; r-- > from;)
            outline << panel.project(sheet.rows[r].back());
        return outline;
    };
    painter.setPen(QPen(flat_tissue::kEdge, 2.0 * panel.unit()));
    painter.setBrush(QColor(236, 196, 140, cues.foldOpen ? 110 : 200));
    painter.drawPolygon(outlineOf(FoldSheet::kEdgeRow, sheet.rows.size() - 1));
    painter.drawPolygon(outlineOf(0, FoldSheet::kEdgeRow));
    const core::Vec3 edge(cues.p_WFoldEdge[0], cues.p_WFoldEdge[1], cues.p_WFoldEdge[2]);
    const double size = 5.0 * panel.unit();
    painter.setPen(QPen(setup.colours.ink, 2.0 * panel.unit()));
    painter.setBrush(cues.foldHeldBy != 0 ? setup.colours.arrow : setup.colours.background);
    painter.drawEllipse(panel.project(edge), size, size);
}

/// Draws a line across the tube at this fraction of its length.
void paintMark(QPainter& painter, const FlatPanel& panel, const TubeCurve& curve, double share) {
    for (const TubePiece& piece : curve.pieces)
        for (std::size_t k = 1; k < piece.rings.size(); ++k) {
            const TubeRing& a = piece.rings[k - 1];
            const TubeRing& b = piece.rings[k];
            if (!(a.share <= share && share < b.share))
                continue;
            const QPointF from = panel.project(a.p_W);
            const QPointF way = panel.project(b.p_W) - from;
            const double length = std::hypot(way.x(), way.y());
            if (length < 1e-6)
                return;
            const QPointF middle = from + (share - a.share) / (b.share - a.share) * way;
            const QPointF beside = QPointF(-way.y(), way.x()) / length * panel.pixels(1e3 * a.radius_m);
            painter.setPen(
                QPen(QColor(44, 26, 96), std::max(1.5, panel.pixels(1.6)), Qt::SolidLine, Qt::FlatCap));
            painter.drawLine(middle - beside, middle + beside);
            return;
        }
}

} // namespace

FlatFrame FlatTube::frame() const {
    return {FlatFloor::rangeAbove_mm(),
            FlatFloor::rangeSide_mm(
                std::min(110.0, 1e3 * m_parameters.restLength_m * m_parameters.tearRatio + 14.0))};
}

void FlatTube::paint(QPainter& painter, const FlatPanel& panel, const SceneSetup& setup,
                     const SceneState& state) const {
    FlatFloor::paint(painter, panel, setup);
    const core::LaparoscopyCues& cues = state.exercise.of<core::LaparoscopyCues>();
    if (!cues.present || !cues.objectShown)
        return;
    const TubeCurve curve = TubeCurve::of(cues, m_parameters.radius_m);
    const QColor edge = flat_tissue::kEdge;
    for (const TubePiece& piece : curve.pieces)
        paintPiece(painter, panel, piece, (setup.colours.highContrast ? 5.0 : 3.0) * panel.unit(), &edge);
    for (const TubePiece& piece : curve.pieces)
        paintPiece(painter, panel, piece, 0.0, nullptr);
    for (const double quarter : {0.25, 0.5, 0.75})
        paintMark(painter, panel, curve, quarter);
    for (int i = 0; i < cues.grips; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const auto& p = cues.p_WGrip[k];
        const QPointF at = panel.project({p[0], p[1], p[2]});
        const double size = 5.0 * panel.unit();
        painter.setPen(QPen(setup.colours.ink, 2.0 * panel.unit()));
        painter.setBrush(cues.gripHeldBy[k] != 0 ? setup.colours.arrow : setup.colours.background);
        // A square is fixed; a circle is to be held, and is filled while it is held.
        if (cues.gripAnchored[k])
            painter.drawRect(QRectF(at.x() - size, at.y() - size, 2.0 * size, 2.0 * size));
        else
            painter.drawEllipse(at, size, size);
    }
    paintFold(painter, panel, setup, cues);
    if (const auto ring = markRing(m_parameters, cues))
        FlatFloor::paintTarget(painter, panel, setup, ring->p_W, ring->radius_m, cues.dwell);
}

std::vector<std::string> FlatTube::marks(const simulation::ElasticTubeParameters& parameters,
                                         const MarkedScene& scene) {
    std::vector<std::string> marks = stageMarks(scene.setup, parameters.tools());
    if (!scene.setup.cues.object)
        return marks;
    marks.push_back("tube_rings");
    if (parameters.task == simulation::TubeTask::transfer || parameters.task == simulation::TubeTask::stretch)
        marks.push_back("target_ring");
    return marks;
}

} // namespace chiron::scene3d
