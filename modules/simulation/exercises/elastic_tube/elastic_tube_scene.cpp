// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/exercises/elastic_tube/elastic_tube_scene.h"

#include <algorithm>

namespace chiron::simulation {

using core::TrialPhase;
namespace bits = core::event_bits;

namespace {

constexpr std::uint64_t kFadeTicks = 300; ///< a pull of 2 N then changes by 7 mN a tick: not felt as a step. Ours.

} // namespace

void ElasticTubeScene::respond(const realtime::HapticTick&, const SceneInput& in, SceneOutput& out) noexcept {
    out = SceneOutput{};
    advance(in, out);
    pull(in.tools, out);
    if (m_phase == TrialPhase::running && !in.paused)
        runTask(out);
    feel(in.tools, out);
    out.trial = static_cast<std::uint16_t>(m_trial);
    out.phase = m_phase;
    fillQuantities(out);
    fillCues(in, out.cues);
}

void ElasticTubeScene::advance(const SceneInput& in, SceneOutput& out) noexcept {
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
            m_clock = 0;
            out.events |= bits::kTrialStarted;
        }
        break;
    case TrialPhase::running:
        if (m_trialOver)
            leaveTrial(out);
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
        m_clock = std::min(m_clock + 1, kFadeTicks);
        break;
    }
}

void ElasticTubeScene::enterReady(SceneOutput& out) noexcept {
    m_phase = TrialPhase::ready;
    m_clock = 0;
    m_trialOver = false;
    const ElasticTubeParameters& p = m_parameters;
    const ElasticTubeTrial& trial = m_trials[m_trial];
    m_tube = TubeChain(elasticTubeShape(p, trial));
    m_grips.reset({p.graspReach_m, p.graspAngle_rad, p.releaseAngle_rad});
    TubeGoal goal;
    goal.task = p.task;
    goal.target_N = trial.target_N;
    goal.band_N = p.band_N;
    goal.mark_m = (p.markRatio - 1.0) * p.restLength_m;
    goal.markTolerance_m = p.markTolerance * p.restLength_m;
    goal.target_W = {p.targetX_m, p.targetY_m, p.targetZ_m};
    goal.targetRadius_m = p.targetRadius_m;
    goal.overStretch_m = (p.overStretchRatio - 1.0) * p.restLength_m;
    goal.tear_m = (p.tearRatio - 1.0) * p.restLength_m;
    goal.hold_ticks = m_holdTicks;
    m_task.begin(goal);
    out.events |= bits::kSceneChanged;
}

void ElasticTubeScene::leaveTrial(SceneOutput& out) noexcept {
    m_clock = 1; // this tick is the first of the interval
    if (m_trial + 1 < m_trials.size()) {
        m_phase = TrialPhase::between;
        return;
    }
    m_phase = TrialPhase::finished;
    out.events |= bits::kFinished;
}

double ElasticTubeScene::fade() const noexcept {
    if (m_phase == TrialPhase::ready || m_phase == TrialPhase::running)
        return m_task.torn() ? 0.0 : 1.0;
    if (m_phase == TrialPhase::idle || m_task.torn() || m_clock >= kFadeTicks)
        return 0.0;
    return 1.0 - static_cast<double>(m_clock) / static_cast<double>(kFadeTicks);
}

bool ElasticTubeScene::tubePresent() const noexcept {
    return m_phase == TrialPhase::ready || m_phase == TrialPhase::running || fade() > 0.0;
}

void ElasticTubeScene::pull(const core::ToolStates& tools, SceneOutput& out) noexcept {
    m_answer = TubeAnswer{};
    if (!tubePresent())
        return;
    const TubeGrips::Change change = m_grips.update(tools, m_tube);
    out.events |= change.grasped ? bits::kGrasped : 0;
    out.events |= change.released ? bits::kReleased : 0;
    m_answer = m_tube.step(m_grips.holds());
}

TubeTaskSample ElasticTubeScene::sample() const noexcept {
    TubeTaskSample now;
    now.tension_N = m_answer.tension_N;
    now.stretch_m = m_answer.stretch_m;
    now.freeEnd_W = m_tube.place(m_tube.shape().nodes - 1);
    now.held = m_grips.count();
    now.rightHolds = m_grips.nodeOf(0) != TubeGrips::kNobody;
    now.leftHolds = m_grips.nodeOf(1) != TubeGrips::kNobody;
    return now;
}

void ElasticTubeScene::runTask(SceneOutput& out) noexcept {
    if (m_trialOver)
        return;
    ++m_clock;
    const TubeTaskTracker::Change change = m_task.advance(sample());
    out.events |= change.moved ? bits::kStageChanged : 0;
    out.events |= change.dropped ? bits::kSlipped : 0;
    out.events |= change.damaged ? bits::kDamaged : 0;
    if (change.completed)
        out.events |= bits::kCompleted;
    else if (change.torn)
        out.events |= bits::kFailed;
    else if (m_clock >= m_limitTicks)
        out.events |= bits::kTimedOut;
    else
        return;
    m_trialOver = true;
}

void ElasticTubeScene::feel(const core::ToolStates& tools, SceneOutput& out) noexcept {
    const double share = fade();
    const int count = std::clamp(tools.count, 0, core::kMaxTools);
    out.tissue.count = count;
    out.energyByBody = true;
    out.bodyEnergy_J[0] = out.storedEnergy_J = share * m_answer.energy_J;
    for (std::size_t i = 0; i < static_cast<std::size_t>(core::kMaxTools); ++i) {
        const bool used = i < static_cast<std::size_t>(count);
        if (used)
            out.p_WProxy[i] = tools.tools[i].p_WT;
        const int node = used ? m_grips.nodeOf(i) : TubeGrips::kNobody;
        if (node != TubeGrips::kNobody) {
            out.tissue.tools[i].force = share * m_answer.force[static_cast<std::size_t>(node)];
            out.contactStiffness_N_per_m =
                std::max(out.contactStiffness_N_per_m, share * m_answer.stiffness_N_per_m[static_cast<std::size_t>(node)]);
        }
        const bool touching = out.tissue.tools[i].force != core::Vec3::Zero();
        if (touching != m_touching[i])
            out.events |= touching ? bits::kContactBegan : bits::kContactEnded;
        m_touching[i] = touching;
    }
    // Every held place may move: with two of them a tick can stretch the tube by both ways, ½k(v₁+v₂)² ≤ ½·2k(v₁²+v₂²).
    // A tube that is held says so while it hangs slack too, by its first slope: its book of energy stays open until it is let go of.
    const double slack = m_grips.count() > 0 ? share * m_tube.shape().law.elastic.slope(0.0) : 0.0;
    out.bodyStiffness_N_per_m[0] = std::max(out.contactStiffness_N_per_m, slack) * std::max(1, m_grips.count());
}

} // namespace chiron::simulation
