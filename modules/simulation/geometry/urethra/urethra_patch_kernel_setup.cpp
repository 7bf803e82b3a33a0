// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/urethra/urethra_patch_kernel.h"

namespace chiron::simulation {

UrethraPatchKernel::UrethraPatchKernel(int columns, int perPatch) : m_size{columns, perPatch} {
    for (Numbers* row : {&m_left, &m_right, &m_spread})
        row->resize(static_cast<std::size_t>(m_size.lanes(kRowLanes)));
    for (Numbers* slope : {&m_end, &m_slope})
        slope->resize(static_cast<std::size_t>(m_size.lanes(kSlopeLanes)));
    for (Numbers* column : {&m_point, &m_chord, &m_q1, &m_q2, &m_q3, &m_lastPoint, &m_lastChord})
        column->resize(static_cast<std::size_t>((columns + 1) * kFour));
    m_curvesAtU.resize(static_cast<std::size_t>((columns + 1) * kCurveFours * kFour));
    // values beyond the patch's side are computed but not used
    for (int q = 0; q < m_size.blocksAPatch() * kLaneWidth; ++q) {
        const double v = static_cast<double>(q) / perPatch;
        const double r = 1.0 - v;
        m_v.push_back(static_cast<float>(v));
        m_first.push_back(q == 0 ? 1.0F : 0.0F);
        m_out.push_back(static_cast<float>(3.0 * v * r * r));
        m_in.push_back(static_cast<float>(3.0 * v * v * r));
        m_chordBulge.push_back(static_cast<float>(3.0 * v * v - 2.0 * v * v * v - v));
        m_outTurn.push_back(static_cast<float>(3.0 * r * (1.0 - 3.0 * v)));
        m_inTurn.push_back(static_cast<float>(3.0 * v * (2.0 - 3.0 * v)));
        m_chordTurn.push_back(static_cast<float>(6.0 * v - 6.0 * v * v - 1.0));
    }
}

} // namespace chiron::simulation
