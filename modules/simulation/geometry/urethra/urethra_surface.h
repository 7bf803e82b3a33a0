// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/urethra/urethra_centreline.h"
#include "simulation/geometry/urethra/urethra_wall.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace chiron::simulation {

/// How finely the urethra is drawn. P1's display: n = 17, w = 26. n counts the first point twice (n = 17: 16 distinct).
struct UrethraMeshSettings {
    int n = 17;               ///< points a section, first = last; 4 < n ≤ 129
    int w = 26;               ///< basic sections, equidistant along z; 4 ≤ w ≤ 401
    int perPatch = 8;         ///< k: each Coons patch is tessellated k × k; 1..32
    int movingSections = 9;   ///< dense sections of the moving deformation from s_t to s_t + ℓ, both included; 3..33
};

/// Where the endoscope is, as the drawn surface needs it. `inside` false: the resting surface.
struct UrethraDeformation {
    bool inside = false;
    double tip_s_m = 0.0; ///< s_t
    double ex_m = 0.0;    ///< e, in the tip's section: x̂
    double en_m = 0.0;    ///< and n
};

/// A vertex range that the last update() rewrote: [first, first + count).
struct VertexRange {
    std::size_t first = 0;
    std::size_t count = 0;
};

/// The urethra's inner surface in A (models.md §1.1; P1 §3, figures 2–4): basic sections and moving deformation,
/// interpolated by piecewise cubic Bézier curves in both directions, Coons patches between them, tessellated k × k.
/// Positions (m) and analytic unit normals towards the lumen's axis, averaged over patch edges. See README.md beside it for
/// layout and definitions. Anatomy, endoscope and settings are valid ones (urethraProblems()).
///
/// Vertices are stored as planes (x…, y…, z…, nx…, ny…, nz…) of float, ring after ring of `ringSize()` vertices; rings run
/// from A to C. The number of vertices and the triangles never change; rings that the deformation covers collapse onto its
/// ends (at rest the spare ones lie on A). In the buffer they run in groups of k, a group a span. Beyond the deformation every vertex is bit-identical to the resting surface, and update() rewrites changed rings only.
/// Not for the tick (it allocates when made). One thread.
class UrethraSurface {
public:
    UrethraSurface(const UrethraAnatomy& anatomy, const Endoscope& endoscope, const UrethraMeshSettings& settings);

    /// Returns what was rewritten, in ascending order without overlaps; empty where nothing changed.
    std::span<const VertexRange> update(const UrethraDeformation& deformation);
    void rebuild(const UrethraDeformation& deformation); ///< everything, whatever it was before (benchmark, first use)

    std::size_t vertexCount() const noexcept;
    std::size_t ringSize() const noexcept; ///< vertices a ring: (n − 1)·k
    std::span<const float> plane(int component) const noexcept; ///< 0..2 position x, y, z (m), 3..5 normal; vertexCount() long
    std::span<const float> arcLength_m() const noexcept;        ///< s of each vertex: texture coordinate along
    std::span<const std::uint32_t> triangles() const noexcept;  ///< three a triangle, seen from inside the lumen
    const UrethraMeshSettings& settings() const noexcept;

    ~UrethraSurface();
    UrethraSurface(const UrethraSurface&) = delete;
    UrethraSurface& operator=(const UrethraSurface&) = delete;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace chiron::simulation
