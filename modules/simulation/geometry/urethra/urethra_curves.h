// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/urethra/coons_patch.h"
#include "simulation/geometry/urethra/urethra_centreline.h"
#include "simulation/geometry/urethra/urethra_section.h"

#include <cstddef>
#include <vector>

namespace chiron::simulation {

/// The curves of the drawn urethra in double precision (models.md §1.1). The sections follow one another;
/// each is a closed curve through n − 1 distinct points, and n − 1 curves along the canal join them. All are
/// piecewise cubic Bézier curves with Catmull–Rom tangents m, chord-length knots and handles P ± m d/3. Span
/// i lies between the sections i and i + 1. The values are stored as planes of doubles, so that the drawn
/// surface is made from the same numbers.
/// Unit: m.
/// Frame: A.
/// Thread: a single one; allocates only when made.
class UrethraCurves {
public:
    /// The values that a section stores for each of its points, with three components each; kChord has one.
    enum Plane { kPoint = 0, kHandleOut = 3, kHandleIn = 6, kAlong = 9, kChord = 12 };

    UrethraCurves(int columns, int mostSections);

    int columns() const noexcept { return m_columns; }
    int sections() const noexcept { return m_sections; }
    int spans() const noexcept { return m_sections - 1; }
    void setSections(int count) noexcept { m_sections = count; }
    double s_m(int section) const noexcept { return m_s_m[static_cast<std::size_t>(section)]; }

    /// Sets the points and peripheral handles of a circle about the shifted centre.
    void placeCircle(int section, const UrethraSection& from, const CentrelinePoint& at) noexcept;
    /// Sets the points, handles and tangents along the canal to those of the resting surface, at the position
    /// that `from` names.
    void placeOnRest(int section, const UrethraSection& from, const UrethraCurves& rest) noexcept;
    /// Computes the tangents along the canal for the sections from `first` to the end; all points must be
    /// placed. The canal's ends are open: m₀ = 2(P₁−P₀)/d₀ − m₁. With `lastIsGiven` the last section keeps
    /// its tangents.
    void fitAlong(int first, bool lastIsGiven) noexcept;

    /// `columns()` values of one component; `plane` is a Plane plus the component.
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
    std::vector<double> m_cosines; ///< cosines of the points' angles from x̂ towards n
    std::vector<double> m_sines;
    double m_handle = 0.0; ///< handle of a unit circle's point: sin δ / 3, δ the angle between points
};

} // namespace chiron::simulation
