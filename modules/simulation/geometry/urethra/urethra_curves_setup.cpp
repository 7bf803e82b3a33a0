// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units.h"
#include "simulation/geometry/urethra/urethra_curves.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

using core::Vec3;

namespace {

/// Sections are at least a micrometre apart; two of their points could coincide only in a wall that was
/// pushed through itself.
constexpr double kLeastChord_m = 1e-12;

} // namespace

UrethraCurves::UrethraCurves(int columns, int mostSections)
    : m_columns(columns), m_s_m(static_cast<std::size_t>(mostSections)),
      m_values(static_cast<std::size_t>(mostSections * kPlanes * columns)) {
    const double step = 2.0 * core::kPi / columns;
    m_handle = std::sin(step) / 3.0;
    for (int j = 0; j < columns; ++j) {
        m_cosines.push_back(std::cos(step * j));
        m_sines.push_back(std::sin(step * j));
    }
}

// The points of a circle have equal chords, so the Catmull–Rom tangent with chord-length knots is
// (P₊ − P₋)/2d, and both handles are (P₊ − P₋)/6 = r sin δ/3 along the tangent of the circle.
void UrethraCurves::placeCircle(int section, const UrethraSection& from, const CentrelinePoint& at) noexcept {
    m_s_m[static_cast<std::size_t>(section)] = from.s_m;
    const double handle = from.radius_m * m_handle;
    const double ny = at.n_A.y();
    const double nz = at.n_A.z();
    double* const point = plane(section, kPoint);
    double* const out = plane(section, kHandleOut);
    double* const in = plane(section, kHandleIn);
    const auto c = static_cast<std::size_t>(m_columns);
    for (std::size_t j = 0; j < c; ++j) {
        const double alongN = from.en_m + from.radius_m * m_sines[j];
        const double turn = handle * m_cosines[j];
        point[j] = from.ex_m + from.radius_m * m_cosines[j];
        point[c + j] = at.p_A.y() + alongN * ny;
        point[2 * c + j] = at.p_A.z() + alongN * nz;
        out[j] = in[j] = -handle * m_sines[j];
        out[c + j] = in[c + j] = turn * ny;
        out[2 * c + j] = in[2 * c + j] = turn * nz;
    }
}

void UrethraCurves::placeOnRest(int section, const UrethraSection& from, const UrethraCurves& rest) noexcept {
    m_s_m[static_cast<std::size_t>(section)] = from.s_m;
    if (from.restParameter <= 0.0) {
        std::copy_n(rest.plane(from.restSpan, 0), static_cast<std::size_t>(kChord * m_columns),
                    plane(section, 0));
        return;
    }
    for (int j = 0; j < m_columns; ++j) {
        const int before = (j + m_columns - 1) % m_columns;
        const PatchPoint point = rest.patch(from.restSpan, j).at(from.restParameter, 0.0);
        const PatchPoint sameFromBefore = rest.patch(from.restSpan, before).at(from.restParameter, 1.0);
        set(section, kPoint, j, point.p_A);
        // A ring of a Coons patch is itself a cubic, so its end slopes are its handles.
        set(section, kHandleOut, j, point.dv_A / 3.0);
        set(section, kHandleIn, j, sameFromBefore.dv_A / 3.0);
        set(section, kAlong, j, point.du_A / rest.plane(from.restSpan, kChord)[j]);
    }
}

void UrethraCurves::fitAlong(int first, bool lastIsGiven) noexcept {
    for (int span = std::max(0, first - 1); span < spans(); ++span)
        measureChords(span);
    for (int section = std::max(1, first); section < spans(); ++section)
        fitInner(section);
    if (first == 0)
        fitEnd(0, 1);
    if (!lastIsGiven)
        fitEnd(spans(), spans() - 1);
}

void UrethraCurves::measureChords(int span) noexcept {
    const auto c = static_cast<std::size_t>(m_columns);
    const double* const a = plane(span, kPoint);
    const double* const b = plane(span + 1, kPoint);
    double* const chord = plane(span, kChord);
    for (std::size_t j = 0; j < c; ++j) {
        const double x = b[j] - a[j];
        const double y = b[c + j] - a[c + j];
        const double z = b[2 * c + j] - a[2 * c + j];
        chord[j] = std::max(kLeastChord_m, std::sqrt(x * x + y * y + z * z));
    }
}

// m = (d₊ (P−P₋)/d₋ + d₋ (P₊−P)/d₊)/(d₋ + d₊)
void UrethraCurves::fitInner(int section) noexcept {
    const auto c = static_cast<std::size_t>(m_columns);
    const double* const before = plane(section - 1, kPoint);
    const double* const here = plane(section, kPoint);
    const double* const after = plane(section + 1, kPoint);
    const double* const chordBefore = plane(section - 1, kChord);
    const double* const chordAfter = plane(section, kChord);
    double* const along = plane(section, kAlong);
    for (std::size_t j = 0; j < c; ++j) {
        const double sum = chordBefore[j] + chordAfter[j];
        const double weightBefore = chordAfter[j] / (chordBefore[j] * sum);
        const double weightAfter = chordBefore[j] / (chordAfter[j] * sum);
        for (std::size_t i = j; i < 3 * c; i += c)
            along[i] = weightBefore * (here[i] - before[i]) + weightAfter * (after[i] - here[i]);
    }
}

// m₀ = 2(P₁−P₀)/d₀ − m₁, and the same at the other end.
void UrethraCurves::fitEnd(int section, int neighbour) noexcept {
    const auto c = static_cast<std::size_t>(m_columns);
    const double sign = neighbour > section ? 1.0 : -1.0;
    const double* const here = plane(section, kPoint);
    const double* const next = plane(neighbour, kPoint);
    const double* const nextAlong = plane(neighbour, kAlong);
    const double* const chord = plane(std::min(section, neighbour), kChord);
    double* const along = plane(section, kAlong);
    for (std::size_t j = 0; j < c; ++j)
        for (std::size_t i = j; i < 3 * c; i += c)
            along[i] = 2.0 * sign * (next[i] - here[i]) / chord[j] - nextAlong[i];
}

void UrethraCurves::set(int section, Plane where, int column, const Vec3& v) noexcept {
    for (int axis = 0; axis < 3; ++axis)
        plane(section, where + axis)[column] = v[axis];
}

Vec3 UrethraCurves::vector(int section, Plane where, int column) const noexcept {
    return {plane(section, where)[column], plane(section, where + 1)[column],
            plane(section, where + 2)[column]};
}

CubicBezier UrethraCurves::along(int span, int column) const noexcept {
    const Vec3 a = vector(span, kPoint, column);
    const Vec3 b = vector(span + 1, kPoint, column);
    const double third = plane(span, kChord)[column] / 3.0;
    return {{a, a + third * vector(span, kAlong, column), b - third * vector(span + 1, kAlong, column), b}};
}

CubicBezier UrethraCurves::around(int section, int column) const noexcept {
    const int next = (column + 1) % m_columns;
    const Vec3 a = vector(section, kPoint, column);
    const Vec3 b = vector(section, kPoint, next);
    return {{a, a + vector(section, kHandleOut, column), b - vector(section, kHandleIn, next), b}};
}

CoonsPatch UrethraCurves::patch(int span, int column) const noexcept {
    return {along(span, column), along(span, (column + 1) % m_columns), around(span, column),
            around(span + 1, column)};
}

} // namespace chiron::simulation
