// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/urethra/urethra_patch_kernel.h"

#include <algorithm>
#include <utility>

namespace chiron::simulation {

SideTables UrethraPatchKernel::tables() const noexcept {
    return {m_v.data(),          m_first.data(),   m_out.data(),    m_in.data(),
            m_chordBulge.data(), m_outTurn.data(), m_inTurn.data(), m_chordTurn.data()};
}

void UrethraPatchKernel::load(const UrethraCurves& curves, int span) noexcept {
    if (holds(curves, span))
        return;
    if (holds(curves, span - 1))
        m_left.swap(m_right);
    else
        fillRow(curves, span, m_left);
    fillRow(curves, span + 1, m_right);
    m_curves = &curves;
    m_span = span;
    m_perLength = static_cast<float>(1.0 / (curves.s_m(span + 1) - curves.s_m(span)));
    subtractLanes(m_right.data(), m_left.data(), m_spread.data(), m_size.lanes(kRowLanes));
    fillColumns(curves, span);
}

void UrethraPatchKernel::fillRow(const UrethraCurves& curves, int section, Numbers& row) noexcept {
    for (int axis = 0; axis < 3; ++axis)
        bulgeLanes(curves.plane(section, UrethraCurves::kPoint + axis),
                   curves.plane(section, UrethraCurves::kHandleOut + axis),
                   curves.plane(section, UrethraCurves::kHandleIn + axis), tables(), m_size, axis,
                   row.data());
}

void UrethraPatchKernel::fillPoints(const UrethraCurves& curves, int section, Numbers& point,
                                    Numbers& chord) noexcept {
    for (int axis = 0; axis < 3; ++axis) {
        const double* const p = curves.plane(section, UrethraCurves::kPoint + axis);
        float* const pointOut = point.data() + axis;
        float* const chordOut = chord.data() + axis;
        for (int j = 0; j < m_size.columns; ++j) {
            pointOut[j * kFour] = static_cast<float>(p[j]);
            chordOut[j * kFour] = static_cast<float>(p[j + 1 < m_size.columns ? j + 1 : 0] - p[j]);
        }
    }
}

// q1 = m d/3, q2 = P₊ − P − m₊ d/3, q3 = P₊ − P: a curve along the canal is P + b1 q1 + b2 q2 + b3 q3.
void UrethraPatchKernel::fillColumns(const UrethraCurves& curves, int span) noexcept {
    fillPoints(curves, span, m_point, m_chord);
    const double* const chord = curves.plane(span, UrethraCurves::kChord);
    for (int axis = 0; axis < 3; ++axis) {
        const double* const p = curves.plane(span, UrethraCurves::kPoint + axis);
        const double* const after = curves.plane(span + 1, UrethraCurves::kPoint + axis);
        const double* const m = curves.plane(span, UrethraCurves::kAlong + axis);
        const double* const mAfter = curves.plane(span + 1, UrethraCurves::kAlong + axis);
        float* const q1 = m_q1.data() + axis;
        float* const q2 = m_q2.data() + axis;
        float* const q3 = m_q3.data() + axis;
        for (int j = 0; j < m_size.columns; ++j) {
            const double third = chord[j] * (1.0 / 3.0);
            const double whole = after[j] - p[j];
            q1[j * kFour] = static_cast<float>(m[j] * third);
            q2[j * kFour] = static_cast<float>(whole - mAfter[j] * third);
            q3[j * kFour] = static_cast<float>(whole);
        }
    }
    for (Numbers* column : {&m_q1, &m_q2, &m_q3})
        std::copy_n(column->begin(), kFour, column->end() - kFour);
}

void UrethraPatchKernel::curvesAt(double u) noexcept {
    const double r = 1.0 - u;
    const std::array<float, 3> weights{static_cast<float>(3.0 * u * r * r),
                                       static_cast<float>(3.0 * u * u * r), static_cast<float>(u * u * u)};
    const std::array<float, 3> slopeWeights{static_cast<float>(3.0 * r * (1.0 - 3.0 * u)),
                                            static_cast<float>(3.0 * u * (2.0 - 3.0 * u)),
                                            static_cast<float>(3.0 * u * u)};
    curveColumns({m_point.data(), m_chord.data(), m_q1.data(), m_q2.data(), m_q3.data()}, weights,
                 slopeWeights, m_size.columns, m_curvesAtU.data());
}

void UrethraPatchKernel::innerRing(double u, const RingPlanes& out) noexcept {
    curvesAt(u);
    innerRingLanes(m_left.data(), m_spread.data(), m_curvesAtU.data(), static_cast<float>(u), tables(),
                   m_size, out);
}

void UrethraPatchKernel::keepEnd() noexcept {
    curvesAt(1.0);
    slopeLanes(m_spread.data(), m_curvesAtU.data(), m_perLength, tables(), m_size, m_end.data());
}

void UrethraPatchKernel::firstRing(bool endIsKept, const RingPlanes& out) noexcept {
    curvesAt(0.0);
    slopeLanes(m_spread.data(), m_curvesAtU.data(), m_perLength, tables(), m_size, m_slope.data());
    if (endIsKept)
        addLanes(m_end.data(), m_slope.data(), m_size.lanes(kSlopeLanes));
    sectionRingLanes(m_left.data(), m_slope.data(), m_point.data(), m_chord.data(), tables(), m_size, out);
}

void UrethraPatchKernel::lastRing(const RingPlanes& out) noexcept {
    curvesAt(1.0);
    slopeLanes(m_spread.data(), m_curvesAtU.data(), m_perLength, tables(), m_size, m_slope.data());
    fillPoints(*m_curves, m_span + 1, m_lastPoint, m_lastChord);
    sectionRingLanes(m_right.data(), m_slope.data(), m_lastPoint.data(), m_lastChord.data(), tables(), m_size,
                     out);
}

} // namespace chiron::simulation
