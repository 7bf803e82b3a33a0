// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/palpation_replay.h"

#include "app/exercises/palpation/scene/palpation_overlay.h"
#include "curriculum/exercises/palpation/scoring/finding_matches.h"
#include "curriculum/exercises/palpation/scoring/findings_trace.h"

#include <algorithm>
#include <string>

namespace chiron::desktop {

namespace {

double valueOf(const session::PlaybackTrack& track, const std::string& id, std::size_t moment) {
    const session::PlaybackQuantity* quantity = track.quantity(id);
    return quantity && moment < quantity->values.size() ? quantity->values[moment] : 0.0;
}

} // namespace

PalpationReplay::PalpationReplay(simulation::PalpationParameters level,
                                 std::vector<session::PalpationTrialRecord> records)
    : m_level(std::move(level)), m_surface(m_level.tissue.shape), m_records(std::move(records)) {}

const session::PalpationTrialRecord* PalpationReplay::record(int trial) const {
    const auto found = std::find_if(m_records.begin(), m_records.end(),
                                    [trial](const auto& record) { return record.trial == trial; });
    return found == m_records.end() ? nullptr : &*found;
}

simulation::PalpationCues PalpationReplay::cuesAt(const session::PlaybackTrack& track, double t_s,
                                                  bool truth) const {
    simulation::PalpationCues cues;
    cues.present = true;
    cues.asksSize = m_level.asksSize;
    cues.asksHardness = m_level.asksHardness;
    cues.asksConfidence = m_level.asksConfidence;
    cues.coverageShown = cues.bandShown = true;
    cues.bandLow_N = m_level.bandLow_N;
    cues.bandHigh_N = m_level.bandHigh_N;
    const std::size_t moment = track.indexAt(t_s);
    cues.coverage = valueOf(track, "coverage", moment);
    for (std::size_t i = 0; i < cues.depth_m.size(); ++i) {
        cues.depth_m[i] = valueOf(track, "depth_" + std::to_string(i) + "_m", moment);
        cues.lean_rad[i] = valueOf(track, "lean_" + std::to_string(i) + "_rad", moment);
    }
    cues.squeezeShown = m_level.pinch.has_value();
    for (std::size_t hand = 0; hand < cues.squeeze_N.size(); ++hand)
        cues.squeeze_N[hand] = valueOf(track, "squeeze_" + std::to_string(hand) + "_N", moment);
    cues.leanSaturated = static_cast<std::uint8_t>(valueOf(track, "lean_saturated", moment));
    const session::PalpationTrialRecord* now = record(track.moments[moment].trial);
    if (!now)
        return cues;
    const simulation::FindingsBook book = scoring::findingsAfter(now->answer.reports, t_s);
    cues.finding = book.list();
    cues.selected = book.selected();
    if (truth)
        addTruth(*now, cues);
    return cues;
}

void PalpationReplay::addTruth(const session::PalpationTrialRecord& record,
                               simulation::PalpationCues& cues) const {
    for (const scoring::LumpTruth& lump : record.answer.truth.lumps) {
        if (cues.lumps >= static_cast<int>(cues.lump.size()))
            return;
        const core::Vec3 centre = lump.place_W - lump.depth_m * m_surface.normalAt(lump.place_W.head<2>());
        cues.lump[static_cast<std::size_t>(cues.lumps++)] = {{centre.x(), centre.y(), centre.z()},
                                                             lump.radius_m};
    }
}

// Outcomes exist only for findings that were still there at the end, at their positions at that time.
void PalpationReplay::addOutcomes(const session::PalpationTrialRecord& record, scene3d::SceneState& state) {
    const auto& cues = state.exercise.of<simulation::PalpationCues>();
    auto& overlay = state.overlay.own<scene3d::PalpationOverlay>();
    for (const scoring::FindingMatch& match : record.answer.matches) {
        const auto i = static_cast<std::size_t>(match.finding);
        if (i < overlay.outcome.size() && cues.finding[i].present &&
            cues.finding[i].p_W == record.answer.findings.list()[i].p_W)
            overlay.outcome[i] =
                match.hit() ? simulation::FindingOutcome::hit : simulation::FindingOutcome::falseAlarm;
    }
    for (int lump = 0; lump < cues.lumps; ++lump)
        if (!scoring::foundBy(record.answer.matches, lump))
            overlay.lumpsMissed = static_cast<std::uint8_t>(overlay.lumpsMissed | (1U << lump));
}

const simulation::SurfaceMap& PalpationReplay::mapAt(const session::PlaybackTrack& track, int trial,
                                                     double t_s) {
    const session::PlaybackTrial* wanted = track.trial(trial);
    const std::size_t upTo = track.indexAt(t_s) + 1;
    if (!m_presses || trial != m_trial || upTo < m_next) {
        m_presses.emplace(m_level);
        m_trial = trial;
        m_next = wanted ? track.indexAt(wanted->start_s) : upTo;
        ++m_shown;
    }
    for (; wanted && m_next < upTo; ++m_next) {
        const session::PlaybackMoment& moment = track.moments[m_next];
        if (moment.paused || moment.t_s < wanted->start_s || moment.t_s > wanted->end_s)
            continue;
        for (int k = 0; k < track.toolCount; ++k)
            m_presses->press(static_cast<std::size_t>(k), track.tool(m_next, k).p_WT,
                             track.tool(m_next, k).tissue_N);
    }
    return m_presses->map();
}

void PalpationReplay::showIn(scene3d::SceneState& state, const session::PlaybackTrack& track, double t_s,
                             const PalpationLook& look) {
    state.exercise.own<simulation::PalpationCues>() = cuesAt(track, t_s, look.truth);
    auto& overlay = state.overlay.own<scene3d::PalpationOverlay>();
    overlay.mapKind = look.map;
    for (scene3d::ToolView& tool : state.tool)
        tool.drawnAtSurface = false; // a fingertip dents what it presses
    const int trial = track.moments[track.indexAt(t_s)].trial;
    const session::PalpationTrialRecord* now = record(trial);
    if (now && look.truth)
        addOutcomes(*now, state);
    overlay.map = now && look.wholeTrial ? &now->map : &mapAt(track, trial, t_s);
    if (overlay.map != m_last || overlay.map->step() != m_lastStep)
        ++m_shown;
    m_last = overlay.map;
    m_lastStep = overlay.map->step();
    overlay.mapStep = m_shown;
}

} // namespace chiron::desktop
