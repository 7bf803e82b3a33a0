// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/playback/grasp_replay.h"

#include "simulation/exercises/elastic_tube/tube_segment.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace chiron::desktop {

using simulation::TubeTask;

namespace {

/// A quantity of the moment by its name; 0 where it was not recorded.
double valueOf(const session::PlaybackTrack& track, const session::PlaybackView& view, const std::string& id) {
    for (std::size_t i = 0; i < track.quantities.size() && i < view.quantities.size(); ++i)
        if (track.quantities[i].id == id)
            return view.quantities[i];
    return 0.0;
}

std::array<double, 3> placeOf(const session::PlaybackTrack& track, const session::PlaybackView& view, const std::string& name) {
    return {valueOf(track, view, name + "_x_m"), valueOf(track, view, name + "_y_m"), valueOf(track, view, name + "_z_m")};
}

core::LaparoscopyStep stepOf(double value) {
    const int step = std::clamp(static_cast<int>(std::lround(value)), 0, core::kLastLaparoscopyStep);
    return static_cast<core::LaparoscopyStep>(step);
}

std::array<double, 3> arrayOf(const core::Vec3& v) { return {v.x(), v.y(), v.z()}; }
core::Vec3 vecOf(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

/// The tip that holds a place; nothing where nobody does.
std::optional<core::Vec3> holderOf(const session::PlaybackView& view, std::uint8_t mask) {
    for (std::size_t i = 0; i < view.tools.size(); ++i)
        if ((mask >> i & 1) != 0)
            return view.tools[i].p_WT;
    return std::nullopt;
}

} // namespace

std::optional<GraspReplay> GraspReplay::of(const session::SessionSetup& setup) {
    GraspReplay replay;
    if (const auto* tube = std::get_if<simulation::ElasticTubeParameters>(&setup.level.parameters)) {
        replay.m_tube = *tube;
        replay.m_tubeTrials = simulation::planElasticTubeTrials(*tube, setup.seed);
        return replay;
    }
    if (const auto* handling = std::get_if<simulation::ObjectHandlingParameters>(&setup.level.parameters)) {
        replay.m_handling = *handling;
        replay.m_handlingTrials = simulation::planObjectHandlingTrials(*handling, setup.seed);
        return replay;
    }
    return std::nullopt;
}

GraspReplay::Band GraspReplay::bandOf(int trial) const {
    const auto i = static_cast<std::size_t>(trial);
    if (!m_tube || trial < 0 || i >= m_tubeTrials.size() || !(m_tubeTrials[i].target_N > 0.0))
        return {};
    return {m_tubeTrials[i].target_N - m_tube->band_N, m_tubeTrials[i].target_N + m_tube->band_N};
}

core::LaparoscopyCues GraspReplay::cuesAt(const session::PlaybackTrack& track, const session::PlaybackView& view) const {
    core::LaparoscopyCues cues;
    const session::PlaybackTrial* trial = track.trial(view.moment.trial);
    const bool torn = view.moment.phase == core::TrialPhase::between && trial && trial->failed; // what is left of it
    const bool there = torn || view.moment.phase == core::TrialPhase::ready || view.moment.phase == core::TrialPhase::running;
    if (!there || track.quantities.empty())
        return cues;
    cues.present = cues.objectShown = true;
    cues.torn = torn;
    cues.step = stepOf(valueOf(track, view, "step"));
    cues.dwell = valueOf(track, view, "dwell");
    if (m_tube && view.moment.trial < m_tubeTrials.size())
        fillTube(track, view, cues);
    if (m_handling && view.moment.trial < m_handlingTrials.size())
        fillObjects(track, view, cues);
    return cues;
}

void GraspReplay::fillTube(const session::PlaybackTrack& track, const session::PlaybackView& view, core::LaparoscopyCues& cues) const {
    const simulation::ElasticTubeTrial& trial = m_tubeTrials[view.moment.trial];
    const bool anchored = m_tube->task != TubeTask::twoHanded;
    cues.tube = true;
    cues.restLength_m = m_tube->restLength_m;
    cues.grips = m_tube->task == TubeTask::transfer ? 3 : 2;
    cues.gripAt = {0.0, cues.grips == 3 ? m_tube->gripShare : 1.0, 1.0};
    cues.gripAnchored[0] = anchored;
    for (std::size_t i = 0; i < 3; ++i)
        cues.gripHeldBy[i] = static_cast<std::uint8_t>(std::lround(valueOf(track, view, "grip_" + std::to_string(i))));
    const auto last = static_cast<std::size_t>(cues.grips - 1);
    const core::Vec3 base(trial.base_m.x(), trial.base_m.y(), 0.0);
    const core::Vec3 end = vecOf(placeOf(track, view, "free_end"));
    cues.p_WGrip[last] = arrayOf(end);
    // The other end of an unfixed tube is where its holder is; held by nobody it was dragged, and lies as far away as it is long.
    const core::Vec3 lying = core::Vec3(end.x() - m_tube->restLength_m, end.y(), m_tube->radius_m);
    cues.p_WGrip[0] = arrayOf(anchored ? base : holderOf(view, cues.gripHeldBy[0]).value_or(lying));
    if (cues.grips == 3) // held: at its holder's tip; free: as the tube has it
        cues.p_WGrip[1] = arrayOf(holderOf(view, cues.gripHeldBy[1])
                                      .value_or(simulation::tubePlace(vecOf(cues.p_WGrip[0]), end, m_tube->restLength_m, m_tube->gripShare)));
    cues.stretch_m = valueOf(track, view, "stretch_m");
    if (m_tube->hasFold())
        fillFold(track, view, cues);
    cues.tensionShown = true;
    cues.tension_N = valueOf(track, view, "tension_N");
    const Band band = bandOf(view.moment.trial);
    cues.bandLow_N = band.low_N;
    cues.bandHigh_N = band.high_N;
    if (m_tube->task == TubeTask::transfer) {
        cues.targetShown = true;
        cues.p_WTarget = {m_tube->targetX_m, m_tube->targetY_m, m_tube->targetZ_m};
        cues.targetRadius_m = m_tube->targetRadius_m;
    }
    cues.targetShown = cues.targetShown || m_tube->task == TubeTask::stretch;
}

void GraspReplay::fillFold(const session::PlaybackTrack& track, const session::PlaybackView& view, core::LaparoscopyCues& cues) const {
    cues.fold = cues.retractionShown = true;
    cues.p_WFoldEdge = placeOf(track, view, "fold_edge");
    cues.p_WFoldBase = arrayOf(simulation::tissueFoldShape(*m_tube, m_tubeTrials[view.moment.trial]).base);
    cues.foldOpen = valueOf(track, view, "fold_open") > 0.5;
    cues.retraction_N = valueOf(track, view, "retraction_N");
    cues.foldHeldBy = static_cast<std::uint8_t>(cues.retraction_N > 0.0 ? 1U << static_cast<unsigned>(m_tube->retractor()) : 0U);
    cues.retractionLow_N = m_tube->retractionLow_N;
    cues.retractionHigh_N = m_tube->retractionHigh_N;
}

void GraspReplay::fillObjects(const session::PlaybackTrack& track, const session::PlaybackView& view, core::LaparoscopyCues& cues) const {
    const simulation::ObjectHandlingTrial& trial = m_handlingTrials[view.moment.trial];
    const int held = static_cast<int>(std::lround(valueOf(track, view, "held"))) - 1;
    cues.squeezeShown = true;
    cues.squeeze_N[0] = valueOf(track, view, "squeeze_N");
    cues.squeezeLimit_N = m_handling->squeezeLimit_N;
    cues.bodies = std::min(trial.objects, static_cast<int>(core::LaparoscopyCues::kMaxBodies));
    for (int i = 0; i < cues.bodies; ++i) {
        core::BodyCue& body = cues.body[static_cast<std::size_t>(i)];
        body.p_W = placeOf(track, view, "body_" + std::to_string(i));
        body.radius_m = m_handling->radius_m;
        if (i != held)
            continue;
        body.heldBy = 1;
        // What the jaws leave of its thickness is how far they are open.
        const double opening_m = 2.0 * m_handling->jawLength_m * std::sin(0.5 * (view.tools.empty() ? 0.0 : view.tools[0].jaw_rad));
        body.squeeze_m = std::max(0.0, 2.0 * m_handling->radius_m - opening_m);
    }
    cues.targetShown = true;
    cues.p_WTarget = {trial.target_m.x(), trial.target_m.y(), 0.0};
    cues.targetRadius_m = m_handling->targetRadius_m;
}

} // namespace chiron::desktop
