// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/urethra/urethra_section_plan.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace {

/// Sections that were nudged are at least this far apart, whatever the rounding.
constexpr double kApart_m = 0.99 * UrethraSectionPlan::kNudge_m;

} // namespace

UrethraSectionPlan::UrethraSectionPlan(const UrethraWall& wall, std::span<const double> basic_s_m,
                                       int movingSections)
    : m_wall(wall), m_basic_s_m(basic_s_m), m_movingSections(movingSections) {
    m_sections.reserve(basic_s_m.size() + static_cast<std::size_t>(movingSections));
}

void UrethraSectionPlan::make(const UrethraDeformation& deformation) {
    m_deformation = deformation;
    m_sections.clear();
    const bool finite = std::isfinite(deformation.tip_s_m) && std::isfinite(deformation.ex_m) &&
                        std::isfinite(deformation.en_m);
    if (!deformation.inside || !finite)
        return;
    findEnd(deformation.tip_s_m + m_wall.endoscope().beak_m); // the same sum at which the wall's windows end
    if (m_end.s_m <= 0.0)
        return;
    int nextMoving = 0;
    for (const double basic : m_basic_s_m) {
        if (m_end.restSpan >= 0 && basic >= m_end.s_m)
            break;
        addMovingBefore(basic, nextMoving);
        m_sections.push_back(opened(basic));
    }
    if (m_end.restSpan >= 0) {
        addMovingBefore(m_end.s_m, nextMoving);
        m_sections.push_back(m_end);
    }
}

// Finds the span that contains the end. If a basic section follows closely, the end is nudged back; if it has
// just passed one, it is put onto it.
void UrethraSectionPlan::findEnd(double end_s_m) noexcept {
    m_end = {};
    m_end.s_m = end_s_m;
    if (end_s_m >= m_basic_s_m.back())
        return;
    const auto after = std::upper_bound(m_basic_s_m.begin(), m_basic_s_m.end(), end_s_m);
    if (after == m_basic_s_m.begin()) { // not inside yet
        m_end.s_m = 0.0;
        return;
    }
    m_end.restSpan = static_cast<int>(after - m_basic_s_m.begin()) - 1;
    const double low = *(after - 1);
    if (end_s_m - low < kNudge_m) {
        m_end.s_m = low;
        return;
    }
    m_end.s_m = std::min(end_s_m, *after - kNudge_m);
    m_end.restParameter = (m_end.s_m - low) / (*after - low);
}

// Keeps a moving section away from basic ones and inside the canal. All sections that would lie outside
// become one just inside, so that the curves' open end does not change when one enters or leaves.
double UrethraSectionPlan::movingAt(int index) const noexcept {
    const double wanted = m_deformation.tip_s_m + m_wall.endoscope().beak_m * index / (m_movingSections - 1);
    const double s = std::clamp(wanted, kNudge_m, m_basic_s_m.back() - kNudge_m);
    const auto after = std::upper_bound(m_basic_s_m.begin(), m_basic_s_m.end(), s);
    if (*after - s < kNudge_m)
        return *after - kNudge_m;
    return std::max(s, *(after - 1) + kNudge_m);
}

// Stops at the last moving section but one, because the last one is the end itself, unless the end is beyond
// C.
void UrethraSectionPlan::addMovingBefore(double s_m, int& next) {
    const int count = m_end.restSpan >= 0 ? m_movingSections - 1 : m_movingSections;
    for (; next < count; ++next) {
        const double s = movingAt(next);
        if (s > s_m - kApart_m)
            return;
        if (s > m_sections.back().s_m + kApart_m) // A's own section is always in the list
            m_sections.push_back(opened(s));
    }
}

// The centre follows the tip by B e both in the free part (which follows the shaft) and in the constrained
// part (which is pushed aside); otherwise the endoscope would leave through the drawn wall. The constraint
// only decides where the offset costs force. Where the canal is wider than the endoscope, only the part of
// the offset that exceeds the slack counts.
UrethraSection UrethraSectionPlan::opened(double s_m) const noexcept {
    const double tip = m_deformation.tip_s_m;
    UrethraSection section;
    section.s_m = s_m;
    section.radius_m = m_wall.openedRadius_m(s_m, tip);
    const double offset = std::hypot(m_deformation.ex_m, m_deformation.en_m);
    if (offset == 0.0)
        return section;
    const double slack = std::max(0.0, m_wall.radius_m(s_m) - m_wall.endoscope().radius_m);
    const double moved = m_wall.following(s_m, tip) * offset - m_wall.opening(s_m, tip) * slack;
    const double share = std::max(0.0, moved) / offset;
    section.ex_m = share * m_deformation.ex_m;
    section.en_m = share * m_deformation.en_m;
    return section;
}

UrethraSection UrethraSectionPlan::basicAtRest(int index) const noexcept {
    UrethraSection section;
    section.s_m = m_basic_s_m[static_cast<std::size_t>(index)];
    section.radius_m = m_wall.radius_m(section.s_m);
    return section;
}

} // namespace chiron::simulation
