// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/object_handling/simulation/object_handling_scene.h"

#include <algorithm>

namespace chiron::simulation {

using core::LaparoscopyStep;
namespace bits = core::event_bits;

void ObjectHandlingScene::respond(const realtime::HapticTick& now, const SceneInput& in,
                                  SceneOutput& out) noexcept {
    out = SceneOutput{};
    m_tick = now.index();
    if (m_softBed && m_softBed->update(m_tick, in.slow))
        out.events |= bits::kSlowApplied;
    const TrialCourse::Turn turn = m_course.advance(in, out);
    if (turn == TrialCourse::Turn::prepares)
        prepare();
    if (turn == TrialCourse::Turn::leaves)
        m_world.clear();
    touch(in, turn == TrialCourse::Turn::runs, out);
    if (m_softBed && m_course.present())
        m_softBed->ask(m_tick);
    m_course.write(in, out);
    fillCues(out);
}

void ObjectHandlingScene::prepare() noexcept {
    const ObjectHandlingTrial& trial = m_trials[m_course.trial()];
    if (m_softBed)
        m_softBed->begin(m_tick);
    if (hasBed())
        m_world.begin(trial);
    m_task.begin(trial);
}

void ObjectHandlingScene::endTrial(SceneOutput& out) noexcept {
    if (m_task.done())
        m_course.end(bits::kCompleted, out);
    else if (m_course.timeIsUp())
        m_course.end(bits::kTimedOut, out);
}

void ObjectHandlingScene::touch(const SceneInput& in, bool running, SceneOutput& out) noexcept {
    const int count = std::clamp(in.tools.count, 0, core::kMaxTools);
    out.tissue.count = count;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        out.p_WProxy[i] = in.tools.tools[i].p_WT;
    const core::ToolState& tool = in.tools.tools[0];
    HandlingTool grasper;
    // A pose that is not finite touches nothing; the supervisor deals with the sample.
    grasper.present = count > 0 && tool.p_WT.allFinite() && tool.v_WT.allFinite();
    if (grasper.present) {
        grasper.p_W = tool.p_WT;
        grasper.v_W = tool.v_WT;
        if (!in.paused)
            m_opening_m = JawGeometry{m_parameters.jawLength_m}.opening_m(tool.jaw_rad);
        grasper.opening_m = m_opening_m;
        grasper.mostDamping_Ns_per_m = in.dampingBudget_Ns_per_m[0];
    }
    HandlingAnswer answer;
    if (m_course.present()) {
        if (hasBed()) {
            answer = m_world.step(grasper);
            m_task.follow(m_world, running);
        } // without its organ nothing is touched, and the trial runs out
        if (running)
            endTrial(out);
        if (grasper.present && hasBed())
            out.p_WProxy[0] = answer.surfacePoint;
        fillQuantities(answer.bedDepth_m, out);
    }
    out.tissue.tools[0].force = answer.force;
    out.contact[0] = answer.contact;
    out.damping_Ns_per_m[0] = answer.damping_Ns_per_m;
    out.storedEnergy_J = out.bodyEnergy_J[0] = answer.energy_J;
    out.contactStiffness_N_per_m = out.bodyStiffness_N_per_m[0] = answer.stiffness_N_per_m;
    out.energyByBody = true;
    out.events |= answer.events;
    if (answer.touching != m_touching)
        out.events |= answer.touching ? bits::kContactBegan : bits::kContactEnded;
    m_touching = answer.touching;
}

void ObjectHandlingScene::fillQuantities(double bedDepth_m, SceneOutput& out) const noexcept {
    namespace q = handling_quantity;
    out.quantities[q::kStep] = static_cast<double>(m_task.step());
    out.quantities[q::kDwell] = m_task.dwell();
    out.quantities[q::kSqueeze] = m_world.squeeze().force_N;
    out.quantities[q::kHeld] = static_cast<double>(m_world.held() + 1);
    for (std::size_t i = 0; i < static_cast<std::size_t>(m_world.count()); ++i)
        for (int axis = 0; axis < 3; ++axis)
            out.quantities[q::kBodies + 3 * i + static_cast<std::size_t>(axis)] = m_world.body(i).p_W[axis];
    out.quantities[q::kBedDepth] = bedDepth_m;
    const PredictionError error = m_softBed ? m_softBed->organ().predictionError() : PredictionError();
    out.quantities[q::kPredictionError] = error.predicted_m;
    out.quantities[q::kHeldError] = error.held_m;
}

void ObjectHandlingScene::showObjects(core::LaparoscopyCues& cues) const noexcept {
    cues.objectShown = true;
    cues.bodies = m_world.count();
    for (std::size_t i = 0; i < static_cast<std::size_t>(m_world.count()); ++i) {
        const LooseBody& body = m_world.body(i);
        core::BodyCue& cue = cues.body[i];
        cue.p_W = {body.p_W.x(), body.p_W.y(), body.p_W.z()};
        cue.q_W = {body.q_W.w(), body.q_W.x(), body.q_W.y(), body.q_W.z()};
        cue.radius_m = body.radius_m();
        if (m_world.held() != static_cast<int>(i))
            continue;
        cue.heldBy = 1;
        cue.squeeze_m = m_world.squeeze().compression_m;
    }
    const core::Vec2& target = m_trials[m_course.trial()].target_m;
    cues.targetShown = true;
    cues.p_WTarget = {target.x(), target.y(), 0.0};
    cues.targetRadius_m = m_parameters.targetRadius_m;
}

void ObjectHandlingScene::fillCues(SceneOutput& out) const noexcept {
    core::VisibleCues& cues = out.cues;
    core::LaparoscopyCues& own = cues.exercise.own<core::LaparoscopyCues>();
    own.present = true;
    if (!m_course.present())
        return;
    cues.timeLeft_s = m_course.timeLeft_s();
    own.step = m_task.step();
    own.dwell = m_task.dwell();
    if (m_showsObjects)
        showObjects(own);
    if (m_showsBars) {
        own.squeezeShown = true;
        own.squeeze_N[0] = m_world.squeeze().force_N;
        own.squeezeLimit_N = m_parameters.squeezeLimit_N;
    }
}

} // namespace chiron::simulation
