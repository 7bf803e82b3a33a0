// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/urethra_drawing.h"

#include "desktop/scene3d/drawn_tool.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

UrethraDrawing::UrethraDrawing(const simulation::UrethraInsertionParameters& parameters)
    : m_parameters(parameters), m_centreline(parameters.anatomy),
      m_neck(m_centreline.atZ(parameters.anatomy.zEnd_m)),
      m_bladderCentre_A(m_neck.p_A + parameters.anatomy.bladderRadius_m * m_neck.t_A) {}

core::Vec3 UrethraDrawing::tip_A(const ToolView& tool) const {
    return m_parameters.pose.pointToA(drawnTip(tool));
}

core::Mat3 UrethraDrawing::axes_A(const ToolView& tool) const {
    core::Quat q_WT = tool.q_WT;
    if (!(q_WT.norm() > 0.5))
        q_WT = core::Quat::Identity();
    return (m_parameters.pose.q_WA.conjugate() * q_WT.normalized()).toRotationMatrix();
}

simulation::UrethraDeformation UrethraDrawing::deformationOf(const ToolView& tool) const {
    simulation::UrethraDeformation deformation;
    if (!tool.present)
        return deformation;
    const simulation::CentrelineFoot foot = m_centreline.foot(tip_A(tool));
    if (foot.at.s_m <= -m_parameters.endoscope.beak_m)
        return deformation;
    return {true, foot.at.s_m, foot.ex_m, foot.en_m};
}

double UrethraDrawing::meteredDistance_m(const ToolView& tool) const {
    const core::Vec3 tip = tip_A(tool);
    const double past = (tip - m_neck.p_A).dot(m_neck.t_A) / kBlend_m;
    if (past <= 0.0)
        return kNear_m;
    const core::Vec3 ahead = -axes_A(tool).col(2);
    const core::Vec3 from = tip - m_bladderCentre_A;
    const double along = from.dot(ahead);
    const double radius = m_parameters.anatomy.bladderRadius_m;
    const double inside = radius * radius - from.squaredNorm() + along * along;
    const double wall = std::max(kNear_m, -along + std::sqrt(std::max(0.0, inside)));
    const double t = std::min(1.0, past);
    return kNear_m + (wall - kNear_m) * t * t * (3.0 - 2.0 * t);
}

core::Vec3 UrethraDrawing::bladderDirection_A(double polar_rad, double azimuth_rad) const {
    return std::cos(polar_rad) * m_neck.t_A +
           std::sin(polar_rad) *
               (std::cos(azimuth_rad) * core::Vec3::UnitX() + std::sin(azimuth_rad) * m_neck.n_A);
}

core::Vec3 UrethraDrawing::bladderWall_A(double polar_rad, double azimuth_rad) const {
    return m_bladderCentre_A +
           m_parameters.anatomy.bladderRadius_m * bladderDirection_A(polar_rad, azimuth_rad);
}

} // namespace chiron::scene3d
