// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/elastic_tube/simulation/elastic_tube_scene.h"

#include "core/contact_bits.h"
#include "core/units.h"

#include <algorithm>

namespace chiron::simulation {

namespace bits = core::event_bits;

namespace {

/// A pull of 2 N then changes by 7 mN per tick, which is not felt as a step. Our choice.
constexpr std::uint64_t kFadeTicks = 300;
/// Share of the pull that opens a fold; below it the fold lies over the tube again. Our choice.
constexpr double kClosesShare = 0.8;
/// A pull of 6 N then changes by 90 mN per tick when the tube is let go of. Our choice.
constexpr std::uint64_t kSlipTicks = 100;

double fallen(double x) noexcept {
    const double t = std::clamp(x, 0.0, 1.0);
    return 1.0 - t * t * (3.0 - 2.0 * t);
}

} // namespace

void ElasticTubeScene::respond(const realtime::HapticTick&, const SceneInput& in, SceneOutput& out) noexcept {
    out = SceneOutput{};
    const TrialCourse::Turn turn = m_course.advance(in, out);
    if (turn == TrialCourse::Turn::prepares)
        prepare();
    pull(in, out);
    if (turn == TrialCourse::Turn::runs)
        runTask(out);
    feel(in.tools, out);
    m_course.write(in, out);
    fillQuantities(out);
    fillCues(out.cues);
}

void ElasticTubeScene::prepare() noexcept {
    const ElasticTubeParameters& p = m_parameters;
    const ElasticTubeTrial& trial = m_trials[m_course.trial()];
    m_tube = TubeChain(elasticTubeShape(p, trial));
    m_grips.reset({p.graspReach_m, p.graspAngle_rad, p.releaseAngle_rad});
    m_fold = p.hasFold() ? TubeChain(tissueFoldShape(p, trial)) : TubeChain();
    m_foldGrips.reset({p.graspReach_m, p.graspAngle_rad, p.releaseAngle_rad});
    m_foldOpen = false;
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
    goal.tear_N = p.yield.force_N;
    goal.hold_ticks = m_holdTicks;
    goal.fold = p.hasFold();
    m_task.begin(goal);
    m_tornTicks = 0;
}

double ElasticTubeScene::fade() const noexcept {
    return m_task.torn() ? tornShare() : ending();
}

double ElasticTubeScene::ending() const noexcept {
    if (m_course.present())
        return 1.0;
    if (m_course.phase() == core::TrialPhase::idle || m_course.clock() >= kFadeTicks)
        return 0.0;
    return 1.0 - static_cast<double>(m_course.clock()) / static_cast<double>(kFadeTicks);
}

double ElasticTubeScene::tornShare() const noexcept {
    return fallen(static_cast<double>(m_tornTicks) * core::kTickSeconds / m_parameters.yield.fall_s);
}

/// The flags of a tool that holds the tube or the fold.
std::uint8_t ElasticTubeScene::contactOf(bool fold, bool beyondChecked) const noexcept {
    namespace contact = core::contact_bits;
    const bool torn = !fold && m_task.torn();
    return static_cast<std::uint8_t>((torn ? contact::kThrough : 0) |
                                     (torn && m_tornTicks == 1 ? contact::kYielded : 0) |
                                     (torn || beyondChecked ? contact::kBeyondChecked : 0));
}

/// The pull on a tool. It continues for a short time after the tool lets go, while the tube slides out of its
/// jaws: friction, which is no part of the tube's potential (models.md §2.4).
core::Vec3 ElasticTubeScene::slipping(std::size_t tool, const core::Vec3& pull, bool holds) noexcept {
    Slip& slip = m_slips[tool];
    if (holds) {
        slip = {pull, 0, true, 1.0};
        return pull;
    }
    slip.share =
        slip.held ? fallen(static_cast<double>(++slip.ticks) / static_cast<double>(kSlipTicks)) : 0.0;
    slip.held = slip.share > 0.0;
    return slip.share * slip.from;
}

bool ElasticTubeScene::tubePresent() const noexcept {
    return m_course.present() || fade() > 0.0 || (m_parameters.hasFold() && ending() > 0.0);
}

void ElasticTubeScene::pull(const SceneInput& in, SceneOutput& out) noexcept {
    m_answer = m_foldAnswer = TubeAnswer{};
    if (!tubePresent())
        return;
    const auto told = [&out](const TubeGrips::Change& change) {
        out.events |= change.grasped ? bits::kGrasped : 0;
        out.events |= change.released ? bits::kReleased : 0;
    };
    const auto answerOf = [&in](TubeChain& chain, const TubeGrips& grips) {
        TubeChain::Holds holds = grips.holds();
        for (std::size_t i = 0; i < in.dampingBudget_Ns_per_m.size(); ++i)
            if (const int node = grips.nodeOf(i); node != TubeGrips::kNobody)
                holds[static_cast<std::size_t>(node)].mostDamping_Ns_per_m = in.dampingBudget_Ns_per_m[i];
        return chain.step(holds);
    };
    if (m_parameters.hasFold()) {
        told(m_foldGrips.update(in.tools, m_fold,
                                {m_parameters.retractor(), m_parameters.retractor() + 1, true}));
        m_foldAnswer = answerOf(m_fold, m_foldGrips);
        openFold();
    }
    told(m_grips.update(in.tools, m_tube,
                        {0, m_parameters.hasFold() ? m_parameters.hands() : core::kMaxTools,
                         !m_parameters.hasFold() || m_foldOpen}));
    m_answer = answerOf(m_tube, m_grips);
}

/// Decides by the fold's elastic tension, not by the force that a quick hand feels.
void ElasticTubeScene::openFold() noexcept {
    const double pull_N = m_fold.shape().law.tension_N(m_foldAnswer.stretch_m);
    m_foldOpen = pull_N >= (m_foldOpen ? kClosesShare : 1.0) * m_parameters.retractionLow_N;
}

TubeTaskSample ElasticTubeScene::sample() const noexcept {
    TubeTaskSample now;
    now.tension_N = m_answer.tension_N;
    now.stretch_m = m_answer.stretch_m;
    now.freeEnd_W = m_tube.place(m_tube.shape().nodes - 1);
    now.held = m_grips.count();
    now.rightHolds = m_grips.nodeOf(0) != TubeGrips::kNobody;
    now.leftHolds = m_grips.nodeOf(1) != TubeGrips::kNobody;
    now.open = !m_parameters.hasFold() || m_foldOpen;
    return now;
}

void ElasticTubeScene::runTask(SceneOutput& out) noexcept {
    const TubeTaskTracker::Change change = m_task.advance(sample());
    out.events |= change.moved ? bits::kStageChanged : 0;
    out.events |= change.dropped ? bits::kSlipped : 0;
    out.events |= change.damaged ? bits::kDamaged : 0;
    if (change.completed)
        m_course.end(bits::kCompleted, out);
    else if (change.torn)
        m_course.end(bits::kFailed, out);
    else if (m_course.timeIsUp())
        m_course.end(bits::kTimedOut, out);
}

void ElasticTubeScene::feel(const core::ToolStates& tools, SceneOutput& out) noexcept {
    if (m_task.torn())
        ++m_tornTicks;
    const int count = std::clamp(tools.count, 0, core::kMaxTools);
    out.tissue.count = count;
    out.energyByBody = true;
    out.bodyEnergy_J[0] = fade() * m_answer.energy_J;
    out.bodyEnergy_J[1] = ending() * m_foldAnswer.energy_J;
    out.storedEnergy_J = out.bodyEnergy_J[0] + out.bodyEnergy_J[1];
    std::array<double, 2> stiffest_N_per_m{}; // of the tube, of the fold
    for (std::size_t i = 0; i < static_cast<std::size_t>(core::kMaxTools); ++i) {
        const bool used = i < static_cast<std::size_t>(count);
        if (used)
            out.p_WProxy[i] = tools.tools[i].p_WT;
        const bool fold = retracts(i);
        out.body[i] = fold ? 1 : 0;
        const TubeAnswer& answer = fold ? m_foldAnswer : m_answer;
        const double share = fold ? ending() : fade();
        const double first_N_per_m = (fold ? m_fold : m_tube).shape().law.elastic.slope(0.0);
        double& stiffest = stiffest_N_per_m[fold ? 1 : 0];
        const int node = used ? (fold ? m_foldGrips : m_grips).nodeOf(i) : TubeGrips::kNobody;
        const bool holds = node != TubeGrips::kNobody;
        core::Vec3 pull = holds ? core::Vec3(share * answer.force[static_cast<std::size_t>(node)])
                                : core::Vec3::Zero().eval();
        // No more than the tube bears, also in tasks without a tear limit
        const bool tooMuch = pull.norm() > m_parameters.yield.force_N;
        if (tooMuch)
            pull *= m_parameters.yield.force_N / pull.norm();
        out.tissue.tools[i].force = used ? slipping(i, pull, holds) : core::Vec3::Zero().eval();
        if (!holds && out.tissue.tools[i].force != core::Vec3::Zero()) // friction still holds what slides
            stiffest = std::max(stiffest, m_slips[i].share * first_N_per_m);
        if (holds) {
            out.contact[i] = contactOf(fold, tooMuch || answer.beyondLimit[static_cast<std::size_t>(node)]);
            stiffest = std::max(stiffest, share * answer.stiffness_N_per_m[static_cast<std::size_t>(node)]);
            out.damping_Ns_per_m[i] = share * answer.damping_Ns_per_m[static_cast<std::size_t>(node)];
        }
        const bool touching = out.tissue.tools[i].force != core::Vec3::Zero();
        if (touching != m_touching[i])
            out.events |= touching ? bits::kContactBegan : bits::kContactEnded;
        m_touching[i] = touching;
    }
    // Every held place may move: with two of them a tick can stretch the tube from both sides,
    // ½k(v₁+v₂)² ≤ ½·2k(v₁²+v₂²). A tube that is held reports its initial slope while it hangs slack, too, so
    // that its energy balance stays open until it is let go of.
    const double slack = m_grips.count() > 0 ? fade() * m_tube.shape().law.elastic.slope(0.0) : 0.0;
    out.bodyStiffness_N_per_m[0] = std::max(stiffest_N_per_m[0], slack) * std::max(1, m_grips.count());
    const double slackFold = m_foldGrips.count() > 0 ? ending() * m_fold.shape().law.elastic.slope(0.0) : 0.0;
    out.bodyStiffness_N_per_m[1] = std::max(stiffest_N_per_m[1], slackFold);
    out.contactStiffness_N_per_m = std::max(stiffest_N_per_m[0], stiffest_N_per_m[1]);
}

} // namespace chiron::simulation
