// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/exercises/urethra_insertion/drawn_tip.h"

#include "simulation/exercises/urethra_insertion/procedure_plan.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

DrawnTip::DrawnTip(const UrethraInsertionParameters& parameters) noexcept
    : m_line(parameters.anatomy.curvature_per_m, parameters.anatomy.zEnd_m), m_pose(parameters.pose),
      m_neck(m_line.atZ(parameters.anatomy.zEnd_m)), m_bladderCentre(bladderCentre_A(parameters.anatomy, m_line)),
      m_bladderRoom_m(std::max(0.0, parameters.anatomy.bladderRadius_m - parameters.endoscope.radius_m)),
      m_beak_m(parameters.endoscope.beak_m) {}

core::Vec3 DrawnTip::at(const core::Vec3& p_A, const CentrelineFoot& foot) const noexcept {
    const core::Vec3 canal = inCanal(p_A, foot);
    if (foot.at.s_m <= m_neck.s_m || canal == p_A)
        return canal;
    const core::Vec3 out = p_A - m_bladderCentre;
    const double distance_m = out.norm();
    if (distance_m <= m_bladderRoom_m)
        return p_A;
    const core::Vec3 bladder = m_bladderCentre + (m_bladderRoom_m / distance_m) * out;
    return (bladder - p_A).squaredNorm() <= (canal - p_A).squaredNorm() ? bladder : canal;
}

core::Vec3 DrawnTip::inCanal(const core::Vec3& p_A, const CentrelineFoot& foot) const noexcept {
    // Past the neck the canal ends where the sphere has become wide enough to hold the endoscope.
    const double end_m = m_neck.s_m + 2.0 * m_beak_m;
    if (foot.at.s_m > end_m) {
        const CentrelinePoint end = m_line.at(end_m);
        const core::Vec3 from = p_A - end.p_A;
        const double distance_m = from.norm();
        return distance_m <= kOffset_m ? p_A : core::Vec3(end.p_A + (kOffset_m / distance_m) * from);
    }
    const double before_m = std::max(0.0, -m_beak_m - foot.at.s_m);
    const double limit_m = kOffset_m + 10.0 * before_m;
    const double offset_m = std::hypot(foot.ex_m, foot.en_m);
    if (offset_m <= limit_m)
        return p_A;
    const double keep = limit_m / offset_m;
    return p_A - (1.0 - keep) * (foot.ex_m * core::Vec3::UnitX() + foot.en_m * foot.at.n_A);
}

core::Vec3 DrawnTip::inW(const core::Vec3& p_WT) const noexcept {
    if (!p_WT.allFinite())
        return p_WT;
    const core::Vec3 p_A = m_pose.pointToA(p_WT);
    const core::Vec3 drawn_A = at(p_A, m_line.foot(p_A));
    return drawn_A == p_A ? p_WT : m_pose.pointToW(drawn_A);
}

} // namespace chiron::simulation
