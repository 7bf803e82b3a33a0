// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/urethra/urethra_surface.h"

#include <Qt3DCore/QBuffer>
#include <Qt3DRender/QGeometryRenderer>
#include <array>
#include <span>

namespace chiron::scene3d {

/// The urethra's surface on its way to the driver: one buffer a component, byte for byte the simulation's own planes, of which
/// only what changed is handed over. The triangles that cross the seam (last to first point of a ring) are drawn apart, with
/// the same vertices, because there the turn round the canal runs on to 1.
class UrethraBuffers {
public:
    UrethraBuffers(const simulation::UrethraSurface& surface, Qt3DCore::QNode* owner);

    /// After UrethraSurface::update(): hands over from the first to the last changed vertex.
    void update(const simulation::UrethraSurface& surface, std::span<const simulation::VertexRange> changed);

    Qt3DRender::QGeometryRenderer* body() const { return m_body; }
    Qt3DRender::QGeometryRenderer* seam() const { return m_seam; }
    /// 0..2 position, 3..5 normal, 6 arc length.
    const Qt3DCore::QBuffer& plane(int component) const { return *m_planes[std::size_t(component)]; }

    static constexpr int kPlanes = 7;

private:
    Qt3DRender::QGeometryRenderer* renderer(const simulation::UrethraSurface& surface, bool seam,
                                            Qt3DCore::QNode* owner);

    std::array<Qt3DCore::QBuffer*, kPlanes> m_planes{};
    Qt3DRender::QGeometryRenderer* m_body;
    Qt3DRender::QGeometryRenderer* m_seam;
};

} // namespace chiron::scene3d
