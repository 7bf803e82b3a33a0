// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/picture_marks.h"

#include "core/units.h"
#include "desktop/scene3d/parts/flat_shapes.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

constexpr double kEdge = 0.007;       // width of the black border of each shape
constexpr double kRing = 0.085;       // radius of the lumen's ring
constexpr double kFrom = 0.56;        // distance of the arrow's start from the middle
constexpr double kLimitLength = 0.24; // length of the arrow at the limit
// Bright against mucosa and against the dark lumen, in every theme; the marks also differ in shape.
const QColor kGuide(140, 240, 255);
const QColor kForce(255, 255, 255);
const QColor kOver(255, 226, 60);

TriangleMesh moved(TriangleMesh mesh, double x) {
    for (MeshVertex& v : mesh.vertices)
        v.position_mm[0] += float(x);
    return mesh;
}

TriangleMesh across(double half, double thick) { // a bar across the direction of the arrow
    TriangleMesh mesh = flatBar(half);
    for (MeshVertex& v : mesh.vertices)
        v.position_mm[0] = float((v.position_mm[0] - 0.5F) * float(2.0 * thick));
    return mesh;
}

} // namespace

PictureMarks::Shape PictureMarks::make(const TriangleMesh& inner, const TriangleMesh& outer) const {
    return std::make_unique<OutlinedShape>(m_effects, inner, outer, m_entity);
}

PictureMarks::PictureMarks(EffectShelf& effects, Qt3DRender::QLayer* layer, Qt3DCore::QEntity* root)
    : m_effects(effects), m_entity(new Qt3DCore::QEntity(root)) {
    m_entity->addComponent(layer);
    const auto ring = [&](double radius, double half) {
        return make(flatRing(radius, half), flatRing(radius, half + kEdge));
    };
    const auto bar = [&](double half) { return make(flatBar(half), flatBar(half + kEdge)); };
    const auto head = [&](double half) {
        return make(moved(flatHead(half), 0.0), moved(flatHead(1.35 * half), -0.16));
    };
    m_target = ring(0.018, 0.005);
    m_ring = ring(kRing, 0.008);
    m_inner = ring(0.6 * kRing, 0.006);
    m_way = bar(0.006);
    m_point = head(0.6);
    m_dwell = ring(0.155, 0.014);
    m_stem = bar(0.014);
    m_head = head(0.55);
    m_limit = make(across(0.055, 0.006), across(0.055 + kEdge, 0.006 + kEdge));
    for (Shape& rung : m_rungs)
        rung = make(across(0.040, 0.006), across(0.040 + kEdge, 0.006 + kEdge));
}

void PictureMarks::change(const SceneSetup& setup) {
    m_guide = setup.colours.highContrast ? QColor(255, 255, 0) : kGuide;
    m_force = kForce;
    m_overForce = kOver;
    for (OutlinedShape* shape :
         {m_target.get(), m_ring.get(), m_inner.get(), m_way.get(), m_point.get(), m_dwell.get()})
        shape->setColour(m_guide);
}

void PictureMarks::show(const ScopeMarks& marks) {
    showGuidance(marks);
    showForce(marks);
}

void PictureMarks::showGuidance(const ScopeMarks& marks) {
    const core::Vec2 way = marks.lumen - marks.target;
    const double away = way.norm();
    const double turn = std::atan2(way.y(), way.x());
    m_target->show(marks.guided);
    m_target->place(marks.target.x(), marks.target.y());
    m_ring->show(marks.guided && !marks.beyond);
    m_ring->place(marks.lumen.x(), marks.lumen.y());
    m_inner->show(marks.guided && marks.aligned);
    m_inner->place(marks.lumen.x(), marks.lumen.y());
    const double from = 0.03;
    const double to = away - (marks.beyond ? 0.0 : kRing);
    m_way->show(marks.guided && to > from + 0.01);
    m_way->place(marks.target.x() + from * std::cos(turn), marks.target.y() + from * std::sin(turn), turn,
                 std::max(0.01, to - from));
    m_point->show(marks.guided && marks.beyond);
    m_point->place(marks.lumen.x(), marks.lumen.y(), turn, 1.0, 0.11);
    m_dwell->show(marks.dwell > 0.0);
    m_dwell->setShare(marks.dwell);
}

void PictureMarks::showForce(const ScopeMarks& marks) {
    const double turn = std::atan2(marks.forceWay.y(), marks.forceWay.x());
    const double length = kLimitLength * std::min(marks.forceShare, ScopeMarks::kLongest);
    const double head = std::min(0.10, 0.6 * length) * (marks.over ? 1.3 : 1.0);
    const auto at = [&](OutlinedShape& shape, double radius, double along, double size) {
        shape.place(radius * marks.forceWay.x(), radius * marks.forceWay.y(), turn, along, size);
    };
    const QColor colour = marks.over ? m_overForce : m_force;
    for (OutlinedShape* shape : {m_stem.get(), m_head.get(), m_limit.get()}) {
        shape->show(marks.force);
        shape->setColour(colour);
    }
    const double thick = marks.over ? 1.5 : 1.0;
    at(*m_stem, kFrom, std::max(0.005, length - head) / thick, thick);
    at(*m_head, kFrom + length - head, 1.0, head);
    at(*m_limit, kFrom + kLimitLength, 1.0, 1.0);
    for (std::size_t i = 0; i < m_rungs.size(); ++i) {
        m_rungs[i]->show(marks.force && marks.over);
        m_rungs[i]->setColour(colour);
        at(*m_rungs[i], kFrom + (length - head) * (0.25 + 0.25 * double(i)), 1.0, 1.0);
    }
}

} // namespace chiron::scene3d
