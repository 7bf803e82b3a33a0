// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/urethra/urethra_surface.h"

#include <Qt3DCore/QBuffer>
#include <Qt3DRender/QGeometryRenderer>
#include <array>
#include <span>
#include <vector>

namespace chiron::scene3d {

/// The urethra's surface as buffers for the graphics driver: one buffer per component, byte for byte the
/// simulation's own planes, of which only the changed part is transferred. The triangles that cross the seam
/// (last to first point of a ring) are drawn separately with the same vertices, because their texture
/// coordinate round the canal continues to 1.
class UrethraBuffers {
public:
    UrethraBuffers(const simulation::UrethraSurface& surface, Qt3DCore::QNode* owner);

    /// Call it after UrethraSurface::update(): transfers the range from the first to the last changed vertex.
    void update(const simulation::UrethraSurface& surface, std::span<const simulation::VertexRange> changed);

    /// Draws the canal only from this arc length on, so that the part behind the camera costs nothing. The
    /// coarse canal is always drawn whole.
    void showFrom(const simulation::UrethraSurface& surface, double from_s_m);

    Qt3DRender::QGeometryRenderer* body() const { return m_body; }
    Qt3DRender::QGeometryRenderer* seam() const { return m_seam; }
    /// The whole canal with a quarter of the vertices for the overview, where it is small; without texture
    /// coordinates round the canal.
    Qt3DRender::QGeometryRenderer* coarse() const { return m_coarse; }
    /// 0..2 position, 3..5 normal, 6 arc length.
    const Qt3DCore::QBuffer& plane(int component) const { return *m_planes[std::size_t(component)]; }

    static constexpr int kPlanes = 7;

private:
    Qt3DRender::QGeometryRenderer* renderer(const simulation::UrethraSurface& surface,
                                            const std::vector<std::uint32_t>& triangles, bool seam,
                                            Qt3DCore::QNode* owner);

    std::array<Qt3DCore::QBuffer*, kPlanes> m_planes{};
    void cut(Qt3DRender::QGeometryRenderer* part, const std::vector<std::uint32_t>& starts, std::size_t ring);

    std::vector<std::uint32_t> m_bodyStarts; ///< number of indices before those of each ring
    std::vector<std::uint32_t> m_seamStarts;
    std::size_t m_from = 0;
    Qt3DRender::QGeometryRenderer* m_body;
    Qt3DRender::QGeometryRenderer* m_seam;
    Qt3DRender::QGeometryRenderer* m_coarse;
};

} // namespace chiron::scene3d
