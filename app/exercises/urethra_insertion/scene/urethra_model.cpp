// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/urethra_model.h"

#include <algorithm>

namespace chiron::scene3d {

namespace {

/// At most 4 × 4 per patch: 8 × 8 brings no visible improvement, and a software rasteriser would process four
/// times as many vertices.
simulation::UrethraMeshSettings drawnMesh(simulation::UrethraMeshSettings mesh) {
    mesh.perPatch = std::min(mesh.perPatch, 4);
    return mesh;
}

constexpr double kBehind_m = 0.015; // length of canal behind the tip that a camera turned to the side can see

void addEntity(Qt3DRender::QGeometryRenderer* shape, Qt3DRender::QMaterial* material,
               Qt3DCore::QEntity* parent) {
    auto* entity = new Qt3DCore::QEntity(parent);
    entity->addComponent(shape);
    entity->addComponent(material);
}

} // namespace

UrethraModel::UrethraModel(const simulation::UrethraInsertionParameters& parameters, Qt3DCore::QNode* owner)
    : m_drawing(parameters), m_surface(parameters.anatomy, parameters.endoscope, drawnMesh(parameters.mesh)),
      m_lining(m_drawing, ring(0), ring(m_surface.vertexCount() - m_surface.ringSize())),
      m_buffers(m_surface, owner), m_bladder(new MeshRenderer(m_lining.bladder(), owner)),
      m_neck(new MeshRenderer(m_lining.neck(ring(m_surface.vertexCount() - m_surface.ringSize())), owner)),
      m_glans(new MeshRenderer(m_lining.glans(ring(0)), owner)) {}

std::vector<core::Vec3> UrethraModel::ring(std::size_t first) const {
    std::vector<core::Vec3> points;
    for (std::size_t i = first; i < first + m_surface.ringSize(); ++i)
        points.emplace_back(m_surface.plane(0)[i], m_surface.plane(1)[i], m_surface.plane(2)[i]);
    return points;
}

void UrethraModel::show(const ToolView& tool) {
    const simulation::UrethraDeformation now = m_drawing.deformationOf(tool);
    const auto changed = m_surface.update(now);
    m_buffers.showFrom(m_surface, now.inside ? now.tip_s_m - kBehind_m : 0.0);
    if (changed.empty())
        return;
    const std::size_t last = m_surface.vertexCount() - m_surface.ringSize();
    const bool atEntrance = changed.front().first < m_surface.ringSize();
    const bool atNeck = changed.back().first + changed.back().count > last;
    m_buffers.update(m_surface, changed);
    if (atEntrance)
        m_glans->setMesh(m_lining.glans(ring(0)));
    if (atNeck)
        m_neck->setMesh(m_lining.neck(ring(last)));
}

void UrethraModel::addCanal(Qt3DRender::QMaterial* material, Qt3DCore::QEntity* parent) const {
    addEntity(m_buffers.body(), material, parent);
    addEntity(m_buffers.seam(), material, parent);
}

void UrethraModel::addCoarseCanal(Qt3DRender::QMaterial* material, Qt3DCore::QEntity* parent) const {
    addEntity(m_buffers.coarse(), material, parent);
}

void UrethraModel::addBladder(Qt3DRender::QMaterial* material, Qt3DCore::QEntity* parent) const {
    addEntity(m_bladder, material, parent);
    addEntity(m_neck, material, parent);
}

void UrethraModel::addGlans(Qt3DRender::QMaterial* material, Qt3DCore::QEntity* parent) const {
    addEntity(m_glans, material, parent);
}

} // namespace chiron::scene3d
