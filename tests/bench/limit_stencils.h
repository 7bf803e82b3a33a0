// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

namespace chiron::bench {

/// The peer of the urethra's surface: OpenSubdiv's limit stencils over a tube of quads (sections × columns
/// control points, closed around), evaluated with their derivatives at perPatch × perPatch places a face and
/// along the last section. The stencils are made once; evaluate() is what a frame would cost. Without
/// OpenSubdiv, available() is false.
class LimitStencils {
public:
    LimitStencils(int sections, int columns, int perPatch);
    ~LimitStencils();
    LimitStencils(const LimitStencils&) = delete;
    LimitStencils& operator=(const LimitStencils&) = delete;

    static bool available();
    /// From control points x, y, z, section after section, to points and unit normals, x, y, z each.
    void evaluate(std::span<const float> control);
    std::span<const float> points() const { return m_points; }
    std::span<const float> normals() const { return m_normals; }

private:
    struct Tables;
    std::unique_ptr<Tables> m_tables;
    std::vector<float> m_points, m_du, m_dv, m_normals;
};

} // namespace chiron::bench
