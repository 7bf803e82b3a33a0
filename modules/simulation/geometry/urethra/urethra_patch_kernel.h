// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/urethra/ring_lanes.h"
#include "simulation/geometry/urethra/urethra_curves.h"

#include <array>
#include <cstddef>
#include <vector>

namespace chiron::simulation {

/// Destination of a ring's vertices: positions x, y, z and normals x, y, z, `columns · perPatch` floats each.
using RingPlanes = std::array<float*, 6>;

/// Tessellates the Coons patches of one span of UrethraCurves in float, a whole ring at a time. With the
/// bulge of a section's curve over its chord, β(v) = d(v) − chord(v), a patch is p = (1−u) β₀ + u β₁ + (1−v)
/// c(u) + v c⁺(u). A ring is therefore a blend of two rows of numbers that are made once per section, plus a
/// line between neighbouring curves. Differences are computed in double before they are rounded, so normals
/// stay accurate on spans of a micrometre. Normals are averaged over patch edges. The same inputs give the
/// same bits on every processor, because the code allows neither contraction nor reassociation.
/// Thread: a single one.
class UrethraPatchKernel {
public:
    UrethraPatchKernel(int columns, int perPatch);

    /// Prepares a span; consecutive spans of the same curves share the row between them. Call forget() first
    /// if the points of the curves have changed.
    void load(const UrethraCurves& curves, int span) noexcept;
    void forget() noexcept { m_curves = nullptr; }

    /// Writes the ring at 0 < u < 1.
    void innerRing(double u, const RingPlanes& out) noexcept;
    /// Writes the section before the loaded span. If keepEnd() was called for the previous span, the normals
    /// are the mean of both spans.
    void firstRing(bool endIsKept, const RingPlanes& out) noexcept;
    /// Writes the section after the loaded span, with this span's normals.
    void lastRing(const RingPlanes& out) noexcept;
    /// Keeps the slopes with which the loaded span arrives at its last section.
    void keepEnd() noexcept;

private:
    using Numbers = std::vector<float>;

    bool holds(const UrethraCurves& curves, int span) const noexcept {
        return m_curves == &curves && m_span == span;
    }
    void fillRow(const UrethraCurves& curves, int section, Numbers& row) noexcept;
    void fillColumns(const UrethraCurves& curves, int span) noexcept;
    void fillPoints(const UrethraCurves& curves, int section, Numbers& point, Numbers& chord) noexcept;
    void curvesAt(double u) noexcept;
    SideTables tables() const noexcept;

    RingSize m_size;
    const UrethraCurves* m_curves = nullptr;
    int m_span = -1;
    float m_perLength = 1.0F; ///< 1/(length of the loaded span)

    Numbers m_left, m_right;                    ///< rows
    Numbers m_spread;                           ///< right − left
    Numbers m_end, m_slope;                     ///< slopes: of the kept end; of the ring being written
    Numbers m_point, m_chord, m_q1, m_q2, m_q3; ///< columns
    Numbers m_lastPoint, m_lastChord;           ///< of the span's other section
    Numbers m_curvesAtU;
    Numbers m_v, m_first, m_out, m_in, m_chordBulge, m_outTurn, m_inTurn, m_chordTurn; ///< SideTables
};

} // namespace chiron::simulation
