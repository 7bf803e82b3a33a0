// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_scene.h"

#include "core/units.h"
#include "modules/exercises/urethra_insertion/cues/procedure_bits.h"
#include "modules/exercises/urethra_insertion/simulation/procedure_plan.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

namespace bits = core::event_bits;

namespace {

constexpr std::uint64_t kLookEvery_ticks = 8; // 125 Hz: twice as often as a screen can show it
constexpr std::uint64_t kTick_us = 1000;
// In each direction; see the header
constexpr double kCheckedOffset_m = 0.006, kCheckedTilt_rad = core::kPi / 6.0;
constexpr double kRounding = 1.0 + 1e-9;

bool isPose(const core::ToolState& tool) noexcept {
    return tool.p_WT.allFinite() && tool.v_WT.allFinite() && tool.w_WT.allFinite() &&
           tool.q_WT.coeffs().allFinite() && tool.q_WT.squaredNorm() > 0.5;
}

std::array<double, 3> arrayOf(const core::Vec3& v) noexcept {
    return {v.x(), v.y(), v.z()};
}

} // namespace

void UrethraInsertionScene::respond(const realtime::HapticTick&, const SceneInput& in,
                                    SceneOutput& out) noexcept {
    out = SceneOutput{};
    sense(in.tools, in.dampingBudget_Ns_per_m[0]);
    if (m_course.advance(in, out) == TrialCourse::Turn::runs)
        runTrial(out);
    answer(in.tools, out);
    m_course.write(in, out);
    fillCues(in, out);
}

/// A pose that is not finite produces no wall force; the supervisor deals with the sample.
void UrethraInsertionScene::sense(const core::ToolStates& tools, double mostDamping_Ns_per_m) noexcept {
    m_sensed = tools.count > 0 && isPose(tools.tools[0]);
    if (!m_sensed) {
        m_response = UrethraResponse{};
        return;
    }
    const core::ToolState& tool = tools.tools[0];
    m_motion.p_A = m_pose.pointToA(tool.p_WT);
    m_motion.axis_A = m_pose.vectorToA(endoscopeAxis_W(tool.q_WT.normalized()));
    m_motion.v_A = m_pose.vectorToA(tool.v_WT);
    m_motion.w_A = m_pose.vectorToA(tool.w_WT);
    m_motion.mostDamping_Ns_per_m = mostDamping_Ns_per_m;
    m_response = m_forces.respond(m_motion);
    // Nothing is felt before the ramp of the force, so the tip counts as inside wherever it is brought in
    if (m_course.phase() != core::TrialPhase::running)
        m_gate.forget();
    m_gate.step(m_response.foot.at.s_m, std::hypot(m_response.foot.ex_m, m_response.foot.en_m));
}

bool UrethraInsertionScene::beyondChecked() const noexcept {
    const CentrelineFoot& foot = m_response.foot;
    if (foot.at.s_m > m_tracker.plan().neck_m)
        return (m_motion.p_A - m_bladderCentre_A).norm() > m_bladderReach_m;
    return std::max(std::abs(foot.ex_m), std::abs(foot.en_m)) > kCheckedOffset_m * kRounding ||
           std::max(std::abs(m_response.phiX_rad), std::abs(m_response.phiY_rad)) >
               kCheckedTilt_rad * kRounding;
}

void UrethraInsertionScene::runTrial(SceneOutput& out) noexcept {
    if (m_sensed) {
        const CentrelineFoot& foot = m_response.foot;
        const ProcedureStep step = m_tracker.advance(
            {foot.at.s_m, m_motion.p_A, m_motion.axis_A, std::hypot(foot.ex_m, foot.en_m)}, kTick_us);
        out.events |= step.stageChanged ? bits::kStageChanged : 0u;
        out.events |= step.seenNow != 0 ? procedure_bits::kLandmarkSeen : 0u;
    }
    if (m_tracker.stage() == simulation::ProcedureStage::completed)
        m_course.end(bits::kCompleted, out);
    else if (m_course.timeIsUp())
        m_course.end(bits::kTimedOut, out);
}

void UrethraInsertionScene::answer(const core::ToolStates& tools, SceneOutput& out) noexcept {
    const int count = std::clamp(tools.count, 0, core::kMaxTools);
    out.tissue.count = count;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        out.p_WProxy[i] = tools.tools[i].p_WT;
    const bool felt = m_sensed && m_course.present();
    const bool touching = felt && m_response.touching && m_gate.inside();
    if (touching != m_touching)
        out.events |= touching ? bits::kContactBegan : bits::kContactEnded;
    m_touching = touching;
    if (!felt)
        m_yield.reset(); // nothing has been seen there yet
    const double whole =
        !felt ? 1.0
              : m_yield.step(touching ? m_response.wrench_A.force.norm() : 0.0, !touching, core::kTickSeconds,
                             touching ? m_response.wrench_A.torque.norm() : 0.0);
    if (!touching)
        return;
    namespace contact = core::contact_bits;
    out.contact[0] = static_cast<std::uint8_t>(
        (m_yield.yielded() ? contact::kYielded : 0) | (m_yield.through() ? contact::kThrough : 0) |
        (m_yield.through() || beyondChecked() ? contact::kBeyondChecked : 0));
    out.tissue.tools[0].force = whole * m_pose.vectorToW(m_response.wrench_A.force);
    out.tissue.tools[0].torque = whole * m_pose.vectorToW(m_response.wrench_A.torque);
    out.storedEnergy_J = whole * m_response.energy_J;
    out.contactStiffness_N_per_m = whole * m_response.stiffness_N_per_m;
    out.damping_Ns_per_m[0] = whole * m_response.damping_Ns_per_m;
    if (m_yield.through())
        return; // drawn at its true position, out of the canal
    const core::Vec3 drawn_A = m_drawn.at(m_motion.p_A, m_response.foot);
    if (drawn_A != m_motion.p_A)
        out.p_WProxy[0] = m_pose.pointToW(drawn_A);
}

void UrethraInsertionScene::fillCues(const SceneInput& in, SceneOutput& out) noexcept {
    core::VisibleCues& cues = out.cues;
    EndoscopeCues& own = cues.exercise.own<EndoscopeCues>();
    own.present = true;
    own.stage = m_tracker.stage();
    own.landmarks = static_cast<int>(m_tracker.plan().landmarks);
    own.landmarksSeen = m_tracker.seen();
    own.dwell = m_tracker.dwell();
    if (!m_course.present())
        return;
    cues.timeLeft_s = m_course.timeLeft_s();
    if (!m_sensed)
        return;
    own.depth_m = m_response.foot.at.s_m;
    if (!m_showsPicture)
        return;
    own.pictureShown = true;
    own.guided = m_showsGuidance;
    const core::Quat q_WT = in.tools.tools[0].q_WT.normalized();
    fillPicture(q_WT, own);
    fillLandmark(q_WT, own);
}

void UrethraInsertionScene::fillPicture(const core::Quat& q_WT, EndoscopeCues& cues) noexcept {
    if (m_looks++ % kLookEvery_ticks == 0)
        m_lumen = m_sight.look(m_motion.p_A, m_motion.axis_A, m_response.foot);
    if (!m_lumen.open)
        return;
    const core::Vec3 to_A = m_lumen.p_A - m_motion.p_A;
    const double distance_m = to_A.norm();
    if (!(distance_m > 0.0))
        return;
    cues.toLumen_T = arrayOf(q_WT.conjugate() * m_pose.vectorToW(to_A / distance_m));
    cues.lumenDistance_m = distance_m;
}

/// A landmark lies in the picture when it is within the field of view, at whatever distance (to count as seen
/// it also has to be near enough). The tip is then past the neck, in the bladder, whose sphere is convex, so
/// nothing lies between.
void UrethraInsertionScene::fillLandmark(const core::Quat& q_WT, EndoscopeCues& cues) const noexcept {
    const int next = m_tracker.nextLandmark();
    if (next < 0 || m_response.foot.at.s_m <= m_tracker.plan().neck_m)
        return;
    const std::array<double, 3>& at = m_tracker.plan().landmark_A[static_cast<std::size_t>(next)];
    const core::Vec3 to_A = core::Vec3(at[0], at[1], at[2]) - m_motion.p_A;
    if (to_A.dot(m_motion.axis_A) < m_cosHalfView * to_A.norm())
        return;
    cues.landmarkShown = true;
    cues.toLandmark_T = arrayOf(q_WT.conjugate() * m_pose.vectorToW(to_A));
}

} // namespace chiron::simulation
