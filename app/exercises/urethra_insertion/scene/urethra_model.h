// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/scene/lining_mesh.h"
#include "app/exercises/urethra_insertion/scene/urethra_buffers.h"
#include "app/exercises/urethra_insertion/scene/urethra_drawing.h"
#include "desktop/scene3d/plugin/qt3d_parts.h"

#include <memory>

namespace chiron::scene3d {

/// The meshes that the camera's picture and the overview share: urethra, bladder, neck, glans. They follow
/// the drawn tip.
class UrethraModel {
public:
    UrethraModel(const simulation::UrethraInsertionParameters& parameters, Qt3DCore::QNode* owner);

    void show(const ToolView& tool);
    const UrethraDrawing& drawing() const { return m_drawing; }

    /// Adds entities with these meshes below `parent`, which is placed at the origin of A: the canal with one
    /// material, bladder and neck with another, the glans with a third. The coarse canal is for the overview.
    void addCoarseCanal(Qt3DRender::QMaterial* material, Qt3DCore::QEntity* parent) const;
    void addCanal(Qt3DRender::QMaterial* material, Qt3DCore::QEntity* parent) const;
    void addBladder(Qt3DRender::QMaterial* material, Qt3DCore::QEntity* parent) const;
    void addGlans(Qt3DRender::QMaterial* material, Qt3DCore::QEntity* parent) const;

private:
    std::vector<core::Vec3> ring(std::size_t first) const;

    UrethraDrawing m_drawing;
    simulation::UrethraSurface m_surface;
    LiningMesh m_lining;
    UrethraBuffers m_buffers;
    MeshRenderer* m_bladder;
    MeshRenderer* m_neck;
    MeshRenderer* m_glans;
};

} // namespace chiron::scene3d
