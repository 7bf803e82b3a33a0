// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/simulation/procedure_plan.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_scene.h"

#include <algorithm>
#include <vector>

/// Parts that tests of urethra insertion share: a pose on the centre-line, an ideal way through the whole
/// procedure.
namespace chiron::tests {

/// A whole procedure: into the bladder, two landmarks, and out.
inline simulation::UrethraInsertionParameters wholeProcedure() {
    simulation::UrethraInsertionParameters p;
    p.landmarks = {{"right", 0.8, 0.0}, {"left", 0.8, 3.14159265358979}};
    p.landmarkHold_s = 0.3;
    p.trialLimit_s = 120.0;
    p.cues = {"object", "tool", "guidance", "overview"};
    return p;
}

/// The endoscope with its tip at `p_A`, looking along `axis_A`, the picture's upper edge towards the
/// patient's front (y_A).
inline core::ToolState endoscopeAt(const simulation::AnatomyPose& pose, const core::Vec3& p_A,
                                   const core::Vec3& axis_A) {
    core::ToolState tool;
    tool.p_WT = pose.pointToW(p_A);
    const core::Vec3 back = -axis_A.normalized(); // z_T
    const core::Vec3 front = std::abs(back.y()) < 0.99 ? core::Vec3::UnitY() : core::Vec3::UnitZ();
    core::Mat3 axes;
    axes.col(0) = front.cross(back).normalized();
    axes.col(1) = back.cross(axes.col(0));
    axes.col(2) = back;
    tool.q_WT = pose.q_WA * core::Quat(axes);
    return tool;
}

/// On the centre-line at s, aligned.
inline core::ToolState onTheLine(const simulation::UrethraInsertionParameters& p, double s_m) {
    const simulation::UrethraCentreline line(p.anatomy);
    const simulation::CentrelinePoint at = line.at(s_m);
    return endoscopeAt(p.pose, at.p_A, at.t_A);
}

/// A perfect hand: along the centre-line to the goal at `speed_m_per_s`, at each landmark a look, and back
/// out. Poses only.
class IdealProcedure {
public:
    explicit IdealProcedure(const simulation::UrethraInsertionParameters& p, double speed_m_per_s = 0.020)
        : m_p(p), m_plan(simulation::procedurePlan(p)), m_step_m(speed_m_per_s * 1e-3) {}

    /// The pose at the next tick, given where the procedure stands.
    core::ToolState next(simulation::ProcedureStage stage, int landmark) {
        using simulation::ProcedureStage;
        if (stage == ProcedureStage::inspection && landmark >= 0) {
            const auto& at = m_plan.landmark_A[static_cast<std::size_t>(landmark)];
            const simulation::UrethraCentreline line(m_p.anatomy);
            const core::Vec3 p_A = line.at(m_s_m).p_A;
            return endoscopeAt(m_p.pose, p_A, core::Vec3(at[0], at[1], at[2]) - p_A);
        }
        const bool out = stage == ProcedureStage::withdrawal || stage == ProcedureStage::completed;
        m_s_m += out ? -m_step_m : m_step_m;
        return onTheLine(m_p, m_s_m);
    }
    double s_m() const { return m_s_m; }

private:
    simulation::UrethraInsertionParameters m_p;
    simulation::ProcedurePlan m_plan;
    double m_step_m;
    double m_s_m = -0.020;
};

} // namespace chiron::tests
