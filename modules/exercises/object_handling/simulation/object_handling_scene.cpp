// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/object_handling/simulation/object_handling_scene.h"

#include "core/units.h"

#include <algorithm>

namespace chiron::simulation {

using core::LaparoscopyStep;
using core::TrialPhase;
namespace bits = core::event_bits;

void ObjectHandlingScene::respond(const realtime::HapticTick& now, const SceneInput& in,
                                  SceneOutput& out) noexcept {
    out = SceneOutput{};
    m_tick = now.index();
    if (m_softBed && m_softBed->update(m_tick, in.slow))
        out.events |= bits::kSlowApplied;
    advance(in, out);
    touch(in, out);
    if (m_softBed && objectsPresent())
        m_softBed->ask(m_tick);
    out.trial = static_cast<std::uint16_t>(m_trial);
    out.phase = m_phase;
    fillCues(in, out);
}

void ObjectHandlingScene::advance(const SceneInput& in, SceneOutput& out) noexcept {
    if (in.paused)
        return;
    switch (m_phase) {
    case TrialPhase::idle:
        if (in.started)
            enterReady(out);
        break;
    case TrialPhase::ready:
        if (in.forceReady) {
            m_phase = TrialPhase::running;
            out.events |= bits::kTrialStarted;
            ++m_clock;
        }
        break;
    case TrialPhase::running:
        if (m_trialOver)
            leaveTrial(out);
        else
            ++m_clock;
        break;
    case TrialPhase::between:
        if (m_clock >= m_betweenTicks) {
            ++m_trial;
            enterReady(out);
        } else {
            ++m_clock;
        }
        break;
    case TrialPhase::finished:
        break;
    }
}

void ObjectHandlingScene::enterReady(SceneOutput& out) noexcept {
    m_phase = TrialPhase::ready;
    m_clock = 0;
    m_trialOver = false;
    if (m_softBed)
        m_softBed->begin(m_tick);
    if (hasBed())
        m_world.begin(m_trials[m_trial]);
    m_task.begin(m_trials[m_trial]);
    out.events |= bits::kSceneChanged;
}

void ObjectHandlingScene::leaveTrial(SceneOutput& out) noexcept {
    m_clock = 1; // this tick is the first of the interval
    m_world.clear();
    if (m_trial + 1 < m_trials.size()) {
        m_phase = TrialPhase::between;
        return;
    }
    m_phase = TrialPhase::finished;
    out.events |= bits::kFinished;
}

void ObjectHandlingScene::endTrial(SceneOutput& out) noexcept {
    if (m_task.done())
        out.events |= bits::kCompleted;
    else if (m_clock >= m_limitTicks)
        out.events |= bits::kTimedOut;
    else
        return;
    m_trialOver = true;
}

bool ObjectHandlingScene::objectsPresent() const noexcept {
    return m_phase == TrialPhase::ready || m_phase == TrialPhase::running;
}

void ObjectHandlingScene::touch(const SceneInput& in, SceneOutput& out) noexcept {
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
    if (objectsPresent()) {
        const bool running = m_phase == TrialPhase::running && !in.paused && !m_trialOver;
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
    const core::Vec2& target = m_trials[m_trial].target_m;
    cues.targetShown = true;
    cues.p_WTarget = {target.x(), target.y(), 0.0};
    cues.targetRadius_m = m_parameters.targetRadius_m;
}

void ObjectHandlingScene::fillCues(const SceneInput& in, SceneOutput& out) const noexcept {
    core::VisibleCues& cues = out.cues;
    core::LaparoscopyCues& own = cues.exercise.own<core::LaparoscopyCues>();
    cues.trial = static_cast<std::uint16_t>(m_trial);
    cues.phase = m_phase;
    cues.force = in.force;
    own.present = true;
    if (!objectsPresent())
        return;
    cues.timeLeft_s = static_cast<double>(m_limitTicks - m_clock) * core::kTickSeconds;
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
