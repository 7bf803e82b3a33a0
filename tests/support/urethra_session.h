// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units.h"
#include "curriculum/exercises/urethra_insertion/scoring/insertion_events.h"
#include "damping/with_budget.h"
#include "devices/drivers/simulated/simulated_endoscope_device.h"
#include "haptics/haptic_loop.h"
#include "haptics/live_inputs.h"
#include "haptics/safety_supervisor.h"
#include "modules/exercises/urethra_insertion/operators/urethra_insertion_operator.h"
#include "modules/exercises/urethra_insertion/simulation/procedure_plan.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_scene.h"
#include "scoring/trace.h"
#include "support/insertion_in.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/// A whole urethra-insertion session of a scripted endoscopist on P1's simulated mechanism, through the real
/// loop, scene and supervisor, as fast as it runs.
namespace chiron::support {

/// The level "standard" of the content, in short form: normal tissue, five landmarks, in and out again.
inline simulation::UrethraInsertionParameters standardInsertion() {
    simulation::UrethraInsertionParameters p;
    const double deg = core::kPi / 180.0;
    p.landmarks = {{"right_wall", 50 * deg, 0.0},
                   {"left_wall", 50 * deg, 180 * deg},
                   {"right_ureter", 58 * deg, -60 * deg},
                   {"left_ureter", 58 * deg, -120 * deg},
                   {"dome", 20 * deg, -90 * deg}};
    p.trialLimit_s = 240.0;
    p.forces.maximumDamping_Ns_per_m = 35.0; // where P1's mechanism was never seen to shake (models.md §8)
    p.anatomy.straight_m = 0.035;
    p.anatomy.zEnd_m = 0.100;
    p.anatomy.pivotSpan_m = 0.020;
    p.meatus_m = 0.005;
    p.anatomy.freeHold_N_per_m = 600.0;
    p.anatomy.wallRetardation_s = 0.005;
    p.yield = {8.0, 0.040};
    p.cues = {"object", "tool", "guidance", "overview"};
    return p;
}

/// What stands between the scene and the endoscopist.
struct UrethraDeception {
    bool mute = false;       ///< force and torque are zero
    bool hidden = false;     ///< there is no picture
    bool upsideDown = false; ///< the lumen is shown as far below the middle as it is above
};

class DeceivedUrethraScene final : public simulation::IScene {
public:
    DeceivedUrethraScene(const simulation::UrethraInsertionParameters& level,
                         const UrethraDeception& deception)
        : m_scene(level), m_deception(deception) {}
    void respond(const realtime::HapticTick& now, const simulation::SceneInput& in,
                 simulation::SceneOutput& out) noexcept override {
        m_scene.respond(now, in, out);
        simulation::EndoscopeCues& cues = out.cues.exercise.own<simulation::EndoscopeCues>();
        if (m_deception.hidden) {
            cues.pictureShown = cues.landmarkShown = false;
            cues.toLumen_T = {};
        }
        if (m_deception.upsideDown)
            cues.toLumen_T[1] = -cues.toLumen_T[1];
        if (m_deception.mute) {
            out.tissue.tools[0] = {};
            out.storedEnergy_J = 0.0;
            out.contactStiffness_N_per_m = 0.0;
        }
    }

private:
    simulation::UrethraInsertionScene m_scene;
    UrethraDeception m_deception;
};

/// Everything that the table shows of one session.
struct UrethraOutcome {
    bool began = false;
    bool completed = false;
    double time_s = 0.0;
    double offsetRms_mm = 0.0, offsetMax_mm = 0.0;
    double alignmentRms_deg = 0.0, bendAlignment_deg = 0.0;
    std::size_t trauma = 0, reversals = 0;
    int landmarks = 0;
    double depth_mm = 0.0;
    double forceP95_N = 0.0, forceMax_N = 0.0;       ///< of the tissue's force
    double torqueP95_mNm = 0.0, torqueMax_mNm = 0.0; ///< of its torque
    double chatter_N = 0.0; ///< RMS of the tissue force's second difference from tick to tick
    double overForce_percent = 0.0, overTorque_percent = 0.0; ///< time over 60 % of 4.5 N and of 150 mN·m
    std::uint64_t digest = 0xcbf29ce484222325ULL;             ///< FNV over all counts: two runs alike
};

/// Reads the trial off the frames, as scoring does.
class UrethraRecorder final : public core::IFrameSink {
public:
    UrethraRecorder(const devices::IToolKinematics& kinematics,
                    const simulation::UrethraInsertionParameters& level)
        : m_kinematics(kinematics), m_level(level), m_forces(level.anatomy, level.endoscope, level.forces),
          m_tracker(simulation::procedurePlan(level)) {
        m_trial.tools.resize(1);
        m_trial.own = std::make_shared<scoring::InsertionSeries>();
        insertionIn(m_trial).lateralLimit_N = level.lateralLimit_N;
    }
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        namespace bits = core::event_bits;
        for (const std::int32_t count : frame.tool[0].counts)
            outcome.digest = (outcome.digest ^ static_cast<std::uint32_t>(count)) * 0x100000001b3ULL;
        m_running = m_running || (frame.header.events & bits::kTrialStarted) != 0;
        if (m_running)
            add(frame);
        outcome.began = outcome.began || m_running;
        if ((frame.header.events & (bits::kCompleted | bits::kTimedOut)) != 0)
            m_running = false;
        outcome.completed = outcome.completed || (frame.header.events & bits::kCompleted) != 0;
        return true;
    }
    UrethraOutcome finish() {
        const scoring::InsertionSeries& series = insertionIn(m_trial);
        const scoring::InsertionEvents events = scoring::insertionEvents(m_trial);
        outcome.trauma = events.trauma.size();
        outcome.reversals = events.reversals.size();
        outcome.landmarks = std::popcount(m_tracker.seen());
        const double L = m_forces.centreline().length_m(), bend = m_level.anatomy.straight_m;
        double e2 = 0.0, a2 = 0.0, b2 = 0.0;
        std::size_t inside = 0, atBend = 0;
        for (std::size_t i = 0; i < series.s_m.size(); ++i) {
            outcome.depth_mm = std::max(outcome.depth_mm, 1e3 * series.s_m[i]);
            const double alignment2 = series.alignment_rad[i] * series.alignment_rad[i];
            if (series.stage[i] == static_cast<std::uint8_t>(simulation::ProcedureStage::insertion) &&
                series.s_m[i] >= bend && series.s_m[i] <= bend + 0.030) { // curve_alignment
                b2 += alignment2;
                ++atBend;
            }
            if (series.s_m[i] < 0.0 || series.s_m[i] > L)
                continue;
            e2 += series.offset_m[i] * series.offset_m[i];
            a2 += alignment2;
            outcome.offsetMax_mm = std::max(outcome.offsetMax_mm, 1e3 * series.offset_m[i]);
            ++inside;
        }
        const auto rms = [](double sum, std::size_t n) {
            return n > 0 ? std::sqrt(sum / static_cast<double>(n)) : 0.0;
        };
        outcome.offsetRms_mm = 1e3 * rms(e2, inside);
        outcome.alignmentRms_deg = core::degFromRad(rms(a2, inside));
        outcome.bendAlignment_deg = core::degFromRad(rms(b2, atBend));
        outcome.time_s = 1e-3 * static_cast<double>(series.s_m.size());
        outcome.chatter_N = rms(m_jumps2, series.s_m.size());
        loads(m_force, 0.6 * 4.5, outcome.forceP95_N, outcome.forceMax_N, outcome.overForce_percent);
        loads(m_torque, 0.6 * 0.150, outcome.torqueP95_mNm, outcome.torqueMax_mNm,
              outcome.overTorque_percent);
        outcome.torqueP95_mNm *= 1e3;
        outcome.torqueMax_mNm *= 1e3;
        return outcome;
    }

    UrethraOutcome outcome;
    /// s, e_n, φ_x, φ_y (m, rad), lateral N, torque N·m, stage, axial N, a tick each.
    std::vector<std::array<double, 8>> story;

private:
    void add(const core::HapticFrame& frame) {
        core::DeviceSample sample;
        sample.counts = frame.tool[0].counts;
        const core::ToolState tool = m_kinematics.pose(sample);
        simulation::EndoscopeMotion motion;
        motion.p_A = m_level.pose.pointToA(tool.p_WT);
        motion.axis_A = m_level.pose.vectorToA(simulation::endoscopeAxis_W(tool.q_WT));
        const simulation::UrethraResponse r = m_forces.respond(motion);
        m_tracker.advance({r.foot.at.s_m, motion.p_A, motion.axis_A, std::hypot(r.foot.ex_m, r.foot.en_m)},
                          1000);
        const core::Wrench tissue = core::toWrench(frame.tool[0].tissue);
        const core::Vec3 t_W = m_level.pose.vectorToW(r.foot.at.t_A);
        const double lateral = (tissue.force - tissue.force.dot(t_W) * t_W).norm();
        scoring::InsertionSeries& series = insertionIn(m_trial);
        m_trial.tools[0].t_s.push_back(1e-3 * static_cast<double>(series.s_m.size()));
        m_trial.tools[0].paused.push_back(0);
        series.s_m.push_back(r.foot.at.s_m);
        series.offset_m.push_back(std::hypot(r.foot.ex_m, r.foot.en_m));
        series.alignment_rad.push_back(std::acos(std::clamp(motion.axis_A.dot(r.foot.at.t_A), -1.0, 1.0)));
        series.lateral_N.push_back(lateral);
        series.stage.push_back(static_cast<std::uint8_t>(m_tracker.stage()));
        m_force.push_back(tissue.force.norm());
        m_jumps2 += (tissue.force - 2.0 * m_last_N + m_before_N).squaredNorm();
        m_before_N = m_last_N;
        m_last_N = tissue.force;
        m_torque.push_back(tissue.torque.norm());
        story.push_back({r.foot.at.s_m, r.foot.en_m, r.phiX_rad, r.phiY_rad, lateral, tissue.torque.norm(),
                         static_cast<double>(m_tracker.stage()), tissue.force.dot(t_W)});
    }
    static void loads(std::vector<double> values, double limit, double& p95, double& most,
                      double& over_percent) {
        if (values.empty())
            return;
        std::sort(values.begin(), values.end());
        p95 = values[static_cast<std::size_t>(0.95 * static_cast<double>(values.size() - 1))];
        most = values.back();
        const auto above = values.end() - std::upper_bound(values.begin(), values.end(), limit);
        over_percent = 100.0 * static_cast<double>(above) / static_cast<double>(values.size());
    }

    const devices::IToolKinematics& m_kinematics;
    simulation::UrethraInsertionParameters m_level;
    simulation::UrethraForces m_forces;
    simulation::ProcedureTracker m_tracker;
    scoring::TrialTrace m_trial;
    std::vector<double> m_force, m_torque;
    core::Vec3 m_last_N = core::Vec3::Zero(), m_before_N = core::Vec3::Zero();
    double m_jumps2 = 0.0;
    bool m_running = false;
};

struct UrethraSession {
    std::string operatorName = "expert";
    std::uint64_t seed = 1;
    simulation::UrethraInsertionParameters level = standardInsertion();
    UrethraDeception deception;
    double budget_Ns_per_m = 0.0; ///< of damping, instead of what the device says it carries; 0: the device's
};

/// Not begun when something could not be made. `story`: what happened, tick by tick.
inline UrethraOutcome runUrethraSession(const UrethraSession& session,
                                        std::vector<std::array<double, 8>>* story = nullptr) {
    const auto settings = operators::urethraInsertionOperatorSettings(session.operatorName);
    if (!settings)
        return {};
    auto mind = operators::makeUrethraInsertionOperator(*settings, session.seed);
    if (!mind)
        return {};
    devices::SimulatedEndoscopeDevice::Configuration configuration;
    configuration.hand = settings->hand;
    configuration.seed = session.seed;
    auto device = devices::SimulatedEndoscopeDevice::create(configuration, std::move(*mind));
    if (!device || !(*device)->open())
        return {};
    std::unique_ptr<devices::IDevice> held = std::move(*device);
    if (session.budget_Ns_per_m > 0.0)
        held = std::make_unique<tests::WithBudget>(std::move(held), session.budget_Ns_per_m);
    UrethraRecorder recorder(held->kinematics(), session.level);
    haptics::SceneExchange scenes;
    std::unique_ptr<simulation::IScene> scene =
        std::make_unique<DeceivedUrethraScene>(session.level, session.deception);
    scenes.offer(scene);
    haptics::LiveInputs inputs;
    haptics::SafetySupervisor supervisor;
    haptics::SafetySettings safety;
    safety.exerciseForce_N = session.level.maximumForce_N;
    safety.exerciseTorque_Nm = session.level.maximumTorque_Nm;
    const std::array<haptics::LoopTool, 1> tools{haptics::LoopTool{*held, {}}};
    auto loop = haptics::HapticLoop::create({tools, inputs, supervisor, safety, scenes, recorder});
    if (!loop)
        return {};
    inputs.post({core::CommandKind::start, 0});
    realtime::TickSource source;
    const auto longest = static_cast<std::uint64_t>(1000.0 * (session.level.trialLimit_s + 20.0));
    while (source.executed() < longest &&
           (*loop)->tick(source.next(static_cast<std::int64_t>(source.executed()) * 1'000'000)))
        ;
    if (story != nullptr)
        *story = recorder.story;
    return recorder.finish();
}

} // namespace chiron::support
