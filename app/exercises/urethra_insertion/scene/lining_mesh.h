// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/scene/urethra_drawing.h"
#include "desktop/scene3d/drawn_mesh.h"

#include <vector>

namespace chiron::scene3d {

/// The surfaces that close the urethra's two open ends: the bladder behind the neck C, and the glans round
/// the meatus A. The normals point to the visible side. Texture: x = turns round the axis, y = fraction of
/// the way from dome to neck (bladder) or of the way outwards (glans).
/// Unit: mm.
/// Frame: A.
class LiningMesh {
public:
    /// `first`, `last`: the urethra's end rings at rest, metres, A.
    LiningMesh(const UrethraDrawing& drawing, std::vector<core::Vec3> first, std::vector<core::Vec3> last);

    /// The sphere up to the circle at which the neck starts to deform.
    TriangleMesh bladder() const;
    /// The part from that circle to the urethra's current last ring; it deforms with the ring.
    TriangleMesh neck(const std::vector<core::Vec3>& last) const;
    /// The glans, from the urethra's current first ring.
    TriangleMesh glans(const std::vector<core::Vec3>& first) const;

private:
    struct Place {
        core::Vec3 p = core::Vec3::Zero();
        core::Vec3 normal = core::Vec3::Zero();
        double across = 0.0;
    };
    double azimuth(std::size_t column) const { return m_azimuths[column % m_azimuths.size()]; }
    Place neckAt(std::size_t column, double way, const std::vector<core::Vec3>& last) const;
    Place glansAt(std::size_t column, double way, const std::vector<core::Vec3>& first) const;

    const UrethraDrawing& m_drawing;
    std::vector<core::Vec3> m_first;
    std::vector<core::Vec3> m_last;
    std::vector<double> m_azimuths; ///< of the last ring's points, about t(C)
    double m_brim_rad;              ///< polar angle from the neck from which on the sphere does not move
};

} // namespace chiron::scene3d
