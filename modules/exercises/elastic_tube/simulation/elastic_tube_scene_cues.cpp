// SPDX-License-Identifier: GPL-3.0-or-later
// The scene's outputs other than forces: recorded quantities and what the screen shows.
#include "modules/exercises/elastic_tube/simulation/elastic_tube_scene.h"

namespace chiron::simulation {

namespace {

std::array<double, 3> arrayOf(const core::Vec3& v) noexcept {
    return {v.x(), v.y(), v.z()};
}

std::uint8_t maskOf(int tool) noexcept {
    return tool == TubeGrips::kNobody ? std::uint8_t{0}
                                      : static_cast<std::uint8_t>(1u << static_cast<unsigned>(tool));
}

} // namespace

void ElasticTubeScene::fillQuantities(SceneOutput& out) const noexcept {
    if (!tubePresent())
        return;
    const auto at = [&](TubeQuantity quantity) -> double& {
        return out.quantities[static_cast<std::size_t>(quantity)];
    };
    at(TubeQuantity::tension_N) = fade() * m_answer.tension_N;
    at(TubeQuantity::stretch_m) = m_answer.stretch_m;
    at(TubeQuantity::grip0) = maskOf(m_grips.holderOf(0));
    at(TubeQuantity::grip1) = maskOf(m_grips.holderOf(1));
    at(TubeQuantity::grip2) = maskOf(m_grips.holderOf(2));
    const core::Vec3& end = m_tube.place(m_tube.shape().nodes - 1);
    at(TubeQuantity::freeEndX_m) = end.x();
    at(TubeQuantity::freeEndY_m) = end.y();
    at(TubeQuantity::freeEndZ_m) = end.z();
    at(TubeQuantity::step) = static_cast<double>(m_task.step());
    at(TubeQuantity::dwell) = m_task.dwell();
    if (!m_parameters.hasFold())
        return;
    at(TubeQuantity::retraction_N) = ending() * m_foldAnswer.tension_N;
    at(TubeQuantity::foldOpen) = m_foldOpen ? 1.0 : 0.0;
    const core::Vec3& edge = m_fold.place(1);
    at(TubeQuantity::foldEdgeX_m) = edge.x();
    at(TubeQuantity::foldEdgeY_m) = edge.y();
    at(TubeQuantity::foldEdgeZ_m) = edge.z();
}

void ElasticTubeScene::fillCues(core::VisibleCues& cues) const noexcept {
    core::LaparoscopyCues& own = cues.exercise.own<core::LaparoscopyCues>();
    own.present = true;
    if (!tubePresent())
        return;
    if (m_course.present()) {
        cues.timeLeft_s = m_course.timeLeft_s();
        own.step = m_task.step();
    }
    if (m_showsObject) {
        cues.objectShown = true;
        cues.p_WObject = m_tube.shape().base;
        cues.objectRadius_m = m_parameters.radius_m;
    }
    fillTube(own);
}

void ElasticTubeScene::fillFold(core::LaparoscopyCues& cues) const noexcept {
    cues.foldOpen = m_foldOpen;
    cues.foldHeldBy = maskOf(m_foldGrips.holderOf(1));
    if (m_showsBars) {
        cues.retractionShown = true;
        cues.retraction_N = ending() * m_foldAnswer.tension_N;
        cues.retractionLow_N = m_parameters.retractionLow_N;
        cues.retractionHigh_N = m_parameters.retractionHigh_N;
    }
    if (!m_showsObject)
        return;
    cues.fold = true;
    cues.p_WFoldEdge = arrayOf(m_fold.place(1));
    cues.p_WFoldBase = arrayOf(m_fold.shape().base);
}

void ElasticTubeScene::fillTube(core::LaparoscopyCues& cues) const noexcept {
    const TubeGoal& goal = m_task.goal();
    if (m_showsObject || m_showsBars)
        cues.dwell = m_task.dwell();
    if (m_showsBars) {
        cues.tensionShown = true;
        cues.tension_N = fade() * m_answer.tension_N;
        if (goal.target_N > 0.0) {
            cues.bandLow_N = goal.target_N - goal.band_N;
            cues.bandHigh_N = goal.target_N + goal.band_N;
        }
    }
    if (m_parameters.hasFold())
        fillFold(cues);
    if (!m_showsObject)
        return;
    cues.objectShown = true;
    cues.tube = true;
    cues.grips = static_cast<int>(m_tube.shape().nodes);
    for (std::size_t i = 0; i < m_tube.shape().nodes; ++i) {
        cues.p_WGrip[i] = arrayOf(m_tube.place(i));
        cues.gripAt[i] = m_tube.shape().share[i];
        cues.gripHeldBy[i] = maskOf(m_grips.holderOf(i));
        cues.gripAnchored[i] = m_tube.shape().fixed && i == 0;
    }
    cues.restLength_m = m_parameters.restLength_m;
    cues.stretch_m = m_answer.stretch_m;
    cues.torn = m_task.torn();
    if (m_parameters.task == TubeTask::transfer) {
        cues.targetShown = true;
        cues.p_WTarget = arrayOf(goal.target_W);
        cues.targetRadius_m = goal.targetRadius_m;
    } else if (m_parameters.task == TubeTask::stretch) { // the mark, straight above the base
        cues.targetShown = true;
        cues.p_WTarget =
            arrayOf(m_tube.shape().base + core::Vec3(0.0, 0.0, m_parameters.restLength_m + goal.mark_m));
        cues.targetRadius_m = goal.markTolerance_m;
    }
}

} // namespace chiron::simulation
