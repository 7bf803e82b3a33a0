// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/urethra/coons_patch.h"
#include "simulation/geometry/urethra/urethra_centreline.h"
#include "simulation/geometry/urethra/urethra_section.h"

#include <cstddef>
#include <vector>

namespace chiron::simulation {

/// The curves of the drawn urethra in double precision (models.md §1.1): sections one after the other, each a
/// closed curve through n − 1 distinct points, joined by n − 1 curves along the canal; all piecewise cubic
/// Bézier with Catmull–Rom tangents m and chord-length knots, handles P ± m d/3. Span i lies between the
/// sections i and i + 1. A, m. Planes of doubles, so that the drawn surface is made from the same numbers.
/// Allocates when made; then one thread.
class UrethraCurves {
public:
    /// What a section stores for each of its points, three components each; kChord only one.
    enum Plane { kPoint = 0, kHandleOut = 3, kHandleIn = 6, kAlong = 9, kChord = 12 };

    UrethraCurves(int columns, int mostSections);

    int columns() const noexcept { return m_columns; }
    int sections() const noexcept { return m_sections; }
    int spans() const noexcept { return m_sections - 1; }
    void setSections(int count) noexcept { m_sections = count; }
    double s_m(int section) const noexcept { return m_s_m[static_cast<std::size_t>(section)]; }

    /// Points and peripheral handles of a circle about the shifted centre.
    void placeCircle(int section, const UrethraSection& from, const CentrelinePoint& at) noexcept;
    /// Points, handles and tangents along of the resting surface itself, where `from` says.
    void placeOnRest(int section, const UrethraSection& from, const UrethraCurves& rest) noexcept;
    /// Tangents along of the sections from `first` to the end, from points that are all placed. The canal's
    /// ends are open: m₀ = 2(P₁−P₀)/d₀ − m₁. With `lastIsGiven` the last section keeps the tangents it has.
    void fitAlong(int first, bool lastIsGiven) noexcept;

    /// `columns()` values of one component of a plane.
    const double* plane(int section, int plane) const noexcept {
        return m_values.data() + at(section, plane);
    }
    core::Vec3 vector(int section, Plane plane, int column) const noexcept;
    CubicBezier along(int span, int column) const noexcept;
    CubicBezier around(int section, int column) const noexcept; ///< from this point to the next
    CoonsPatch patch(int span, int column) const noexcept;

private:
    static constexpr int kPlanes = 13;

    std::size_t at(int section, int plane) const noexcept {
        return static_cast<std::size_t>((section * kPlanes + plane) * m_columns);
    }
    double* plane(int section, int plane) noexcept { return m_values.data() + at(section, plane); }
    void set(int section, Plane plane, int column, const core::Vec3& v) noexcept;
    void measureChords(int span) noexcept;
    void fitInner(int section) noexcept;
    void fitEnd(int section, int neighbour) noexcept;

    int m_columns;
    int m_sections = 0;
    std::vector<double> m_s_m;
    std::vector<double> m_values;
    std::vector<double> m_cosines; ///< of the points' angles from x̂ towards n
    std::vector<double> m_sines;
    double m_handle = 0.0; ///< handle of a unit circle's point: sin δ / 3, δ the angle between points
};

} // namespace chiron::simulation
