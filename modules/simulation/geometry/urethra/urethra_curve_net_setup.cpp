// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units.h"
#include "simulation/geometry/urethra/urethra_curve_net.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

using core::Vec3;

namespace {

/// Share of a patch's side: an angle this near to a point's differs from it only by rounding.
constexpr double kOnAnEdge = 1e-9;

std::vector<double> basicSections(const UrethraCentreline& line, double zEnd_m, int count) {
    std::vector<double> s_m;
    for (int i = 0; i < count; ++i)
        s_m.push_back(i == count - 1 ? line.length_m() : line.arcLengthAt(zEnd_m * i / (count - 1)));
    return s_m;
}

// At a section each of the two neighbouring spans has a derivative along the canal, and at a patch's edge
// each of the two patches has one around it. The normal uses their means.
Vec3 meanNormal(const UrethraCurves& curves, int span, int column, double u, double v,
                const PatchPoint& here) {
    const auto perMetre = [&](int of) { return 1.0 / (curves.s_m(of + 1) - curves.s_m(of)); };
    Vec3 along = here.du_A * perMetre(span);
    Vec3 around = here.dv_A;
    if (u <= 0.0 && span > 0)
        along = 0.5 * (along + curves.patch(span - 1, column).at(1.0, v).du_A * perMetre(span - 1));
    if (u >= 1.0 && span + 1 < curves.spans())
        along = 0.5 * (along + curves.patch(span + 1, column).at(0.0, v).du_A * perMetre(span + 1));
    if (v <= 0.0) {
        const int before = (column + curves.columns() - 1) % curves.columns();
        around = 0.5 * (around + curves.patch(span, before).at(u, 1.0).dv_A);
    }
    return along.cross(around).normalized();
}

} // namespace

UrethraCurveNet::UrethraCurveNet(const UrethraAnatomy& anatomy, const Endoscope& endoscope,
                                 const UrethraMeshSettings& settings)
    : m_centreline(anatomy), m_wall(anatomy, endoscope),
      m_basic_s_m(basicSections(m_centreline, anatomy.zEnd_m, settings.w)),
      m_plan(m_wall, m_basic_s_m, settings.movingSections), m_rest(settings.n - 1, settings.w),
      m_deformed(settings.n - 1, settings.w + settings.movingSections) {
    m_rest.setSections(settings.w);
    for (int i = 0; i < settings.w; ++i) {
        m_basicAt.push_back(m_centreline.at(m_basic_s_m[static_cast<std::size_t>(i)]));
        m_rest.placeCircle(i, m_plan.basicAtRest(i), m_basicAt.back());
    }
    m_rest.fitAlong(0, false);
    m_placed.reserve(m_plan.sections().capacity());
}

int UrethraCurveNet::deform(const UrethraDeformation& deformation) {
    m_plan.make(deformation);
    const std::vector<UrethraSection>& sections = m_plan.sections();
    const auto same = std::mismatch(sections.begin(), sections.end(), m_placed.begin(), m_placed.end()).first;
    const int first = static_cast<int>(same - sections.begin());
    const int count = static_cast<int>(sections.size());
    const bool unchanged = first == count && sections.size() == m_placed.size();
    m_deformed.setSections(count);
    if (unchanged || count == 0) {
        m_placed = sections;
        return count;
    }
    for (int i = first; i < count; ++i) {
        const UrethraSection& section = sections[static_cast<std::size_t>(i)];
        if (section.restSpan >= 0)
            m_deformed.placeOnRest(i, section, m_rest);
        else
            m_deformed.placeCircle(i, section, m_centreline.at(section.s_m));
    }
    m_placed = sections;
    // A tangent depends on both neighbours; that of the open end also depends on the section after next.
    const int firstTangent = first <= 2 ? 0 : first - 1;
    m_deformed.fitAlong(firstTangent, m_plan.endsOnRest());
    return std::max(0, firstTangent - 1);
}

int UrethraCurveNet::deformAnew(const UrethraDeformation& deformation) {
    m_placed.clear();
    deform(deformation);
    return 0;
}

UrethraSurfacePoint UrethraCurveNet::at(double s_m, double angle_rad) const noexcept {
    const bool moved = m_deformed.sections() > 1 && s_m < m_deformed.s_m(m_deformed.spans());
    const UrethraCurves& curves =
        moved || (m_deformed.sections() > 1 && !m_plan.endsOnRest()) ? m_deformed : m_rest;
    const double s = std::clamp(s_m, 0.0, m_centreline.length_m());
    int span = curves.spans() - 1;
    while (span > 0 && curves.s_m(span) > s)
        --span;
    const double u = (s - curves.s_m(span)) / (curves.s_m(span + 1) - curves.s_m(span));
    const double turns = angle_rad / (2.0 * core::kPi);
    const double place = (turns - std::floor(turns)) * curves.columns();
    const double edge = std::round(place);
    const double held = std::abs(place - edge) < kOnAnEdge ? edge : place;
    const int column = static_cast<int>(held) % curves.columns();
    const double v = held - std::floor(held);
    const PatchPoint point = curves.patch(span, column).at(u, v);
    return {point.p_A, meanNormal(curves, span, column, u, v, point)};
}

} // namespace chiron::simulation
