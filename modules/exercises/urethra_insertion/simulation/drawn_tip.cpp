// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/urethra_insertion/simulation/drawn_tip.h"

#include "modules/exercises/urethra_insertion/simulation/procedure_plan.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

DrawnTip::DrawnTip(const UrethraInsertionParameters& parameters) noexcept
    : m_line(parameters.anatomy), m_pose(parameters.pose), m_neck(m_line.atZ(parameters.anatomy.zEnd_m)),
      m_bladderCentre(bladderCentre_A(parameters.anatomy, m_line)),
      m_bladderRadius_m(parameters.anatomy.bladderRadius_m),
      m_bladderRoom_m(std::max(0.0, parameters.anatomy.bladderRadius_m - parameters.endoscope.radius_m)),
      m_beak_m(parameters.endoscope.beak_m) {}

core::Vec3 DrawnTip::at(const core::Vec3& p_A, const CentrelineFoot& foot) const noexcept {
    return foot.at.s_m > m_neck.s_m ? pastNeck(p_A, foot.at.s_m) : inCanal(p_A, foot);
}

core::Vec3 DrawnTip::inCanal(const core::Vec3& p_A, const CentrelineFoot& foot) const noexcept {
    const double before_m = std::max(0.0, -m_beak_m - foot.at.s_m);
    const double limit_m = kOffset_m + kOpening * before_m;
    const double offset_m = std::hypot(foot.ex_m, foot.en_m);
    if (offset_m <= limit_m)
        return p_A;
    const double keep = limit_m / offset_m;
    return p_A - (1.0 - keep) * (foot.ex_m * core::Vec3::UnitX() + foot.en_m * foot.at.n_A);
}

// At the neck the middle is C and the outward direction lies in the section, so the canal's limit passes into
// the sphere's without a step. A line that only grazes the sphere from outside leaves the tip within the
// canal's limit.
core::Vec3 DrawnTip::pastNeck(const core::Vec3& p_A, double s_m) const noexcept {
    if ((p_A - m_bladderCentre).squaredNorm() <= m_bladderRoom_m * m_bladderRoom_m)
        return p_A;
    const core::Vec3 middle = m_neck.p_A + std::min(s_m - m_neck.s_m, m_bladderRadius_m) * m_neck.t_A;
    const core::Vec3 out = p_A - middle;
    const double distance_m = out.norm();
    if (distance_m <= kOffset_m)
        return p_A;
    const core::Vec3 way = out / distance_m;
    const double limit_m = std::max(kOffset_m, wayOutOfBladder_m(middle, way));
    return distance_m <= limit_m ? p_A : core::Vec3(middle + limit_m * way);
}

double DrawnTip::wayOutOfBladder_m(const core::Vec3& from_A, const core::Vec3& way_A) const noexcept {
    const core::Vec3 from = from_A - m_bladderCentre;
    const double along_m = way_A.dot(from);
    const double square_m2 = along_m * along_m + m_bladderRoom_m * m_bladderRoom_m - from.squaredNorm();
    return square_m2 <= 0.0 ? 0.0 : std::sqrt(square_m2) - along_m;
}

core::Vec3 DrawnTip::inW(const core::Vec3& p_WT) const noexcept {
    if (!p_WT.allFinite())
        return p_WT;
    const core::Vec3 p_A = m_pose.pointToA(p_WT);
    const core::Vec3 drawn_A = at(p_A, m_line.foot(p_A));
    return drawn_A == p_A ? p_WT : m_pose.pointToW(drawn_A);
}

} // namespace chiron::simulation
