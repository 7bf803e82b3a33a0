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

/// Resolution of the drawn urethra. P1's display: n = 17, w = 26. n counts the first point twice (n = 17: 16
/// distinct).
struct UrethraMeshSettings {
    int n = 17;       ///< points per section, first = last; 4 < n ≤ 129
    int w = 26;       ///< basic sections, equidistant along z; 4 ≤ w ≤ 401
    int perPatch = 8; ///< k: each Coons patch is tessellated k × k; 1..32
    /// Dense sections of the moving deformation from s_t to s_t + ℓ, both included; 3..33.
    int movingSections = 9;
};

/// Position of the endoscope, as the drawn surface needs it. `inside` false: the surface is at rest.
struct UrethraDeformation {
    bool inside = false;
    double tip_s_m = 0.0; ///< s_t
    double ex_m = 0.0;    ///< e in the tip's section: along x̂
    double en_m = 0.0;    ///< and along n
};

/// A vertex range that the last update() rewrote: [first, first + count).
struct VertexRange {
    std::size_t first = 0;
    std::size_t count = 0;
};

/// The urethra's inner surface in A (models.md §1.1; P1 §3, figures 2–4). Basic sections and the moving
/// deformation are interpolated by piecewise cubic Bézier curves in both directions, with Coons patches
/// between them, tessellated k × k. It provides positions (m) and analytic unit normals towards the lumen's
/// axis, averaged over patch edges. See README.md beside it for layout and definitions. Anatomy, endoscope
/// and settings must be valid (urethraProblems()).
///
/// Vertices are stored as planes (x…, y…, z…, nx…, ny…, nz…) of float, ring after ring of `ringSize()`
/// vertices; rings run from A to C. In the buffer they form groups of k, one group per span. The number of
/// vertices and the triangles never change; rings that the deformation covers collapse onto its ends (at rest
/// the spare ones lie on A). Beyond the deformation every vertex is bit-identical to the resting surface, and
/// update() rewrites only changed rings. Not for use in the tick (it allocates when made).
///
/// Thread: a single one.
class UrethraSurface {
public:
    UrethraSurface(const UrethraAnatomy& anatomy, const Endoscope& endoscope,
                   const UrethraMeshSettings& settings);

    /// Returns the vertex ranges that it rewrote, in ascending order without overlaps; empty if nothing
    /// changed.
    std::span<const VertexRange> update(const UrethraDeformation& deformation);
    void rebuild(const UrethraDeformation& deformation); ///< rewrites everything (benchmark, first use)

    std::size_t vertexCount() const noexcept;
    std::size_t ringSize() const noexcept; ///< vertices per ring: (n − 1)·k
    std::span<const float>
    plane(int component) const noexcept; ///< 0..2 position x, y, z (m), 3..5 normal; vertexCount() long
    /// s of each vertex: texture coordinate along the canal.
    std::span<const float> arcLength_m() const noexcept;
    /// Three indices per triangle; the front faces are those seen from inside the lumen.
    std::span<const std::uint32_t> triangles() const noexcept;
    const UrethraMeshSettings& settings() const noexcept;

    ~UrethraSurface();
    UrethraSurface(const UrethraSurface&) = delete;
    UrethraSurface& operator=(const UrethraSurface&) = delete;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace chiron::simulation
