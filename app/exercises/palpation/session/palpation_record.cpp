// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/session/palpation_record.h"

#include "app/exercises/palpation/session/palpation_presses.h"

#include <string>
#include <utility>

namespace chiron::session {

namespace {

double lastCoverage(const scoring::TrialTrace& trial) {
    for (const scoring::QuantityTrace& quantity : trial.quantities)
        if (quantity.id == "coverage" && !quantity.values.empty())
            return quantity.values.back();
    return 0.0;
}

} // namespace

simulation::SurfaceMap emptyMapOf(const simulation::PalpationParameters& level) {
    return {level.areaHalf_m, level.tissue.contactRadius_m, level.coverForce_N};
}

simulation::MapBands mapBandsOf(const simulation::PalpationParameters& level) {
    return {level.coverForce_N, level.bandLow_N, level.bandHigh_N, level.maximumForce_N};
}

simulation::SurfaceMap mapOf(const simulation::PalpationParameters& level, const scoring::TrialTrace& trial) {
    PalpationPresses presses(level);
    for (std::size_t i = 0; i < trial.tools.size(); ++i) {
        const scoring::ToolTrace& tool = trial.tools[i];
        for (std::size_t k = 0; k < tool.t_s.size(); ++k)
            if (tool.paused[k] == 0)
                presses.press(i, tool.p_WT_m[k], tool.tissue_N[k]);
    }
    return presses.map();
}

simulation::SurfaceMap mapAt(const simulation::PalpationParameters& level, const PlaybackTrack& track,
                             int trial, double t_s) {
    PalpationPresses presses(level);
    const PlaybackTrial* wanted = track.trial(trial);
    if (wanted == nullptr)
        return presses.map();
    for (std::size_t i = track.indexAt(wanted->start_s); i < track.moments.size(); ++i) {
        const PlaybackMoment& moment = track.moments[i];
        if (moment.t_s > t_s || moment.t_s > wanted->end_s)
            break;
        if (moment.paused || moment.t_s < wanted->start_s)
            continue;
        for (int k = 0; k < track.toolCount; ++k)
            presses.press(static_cast<std::size_t>(k), track.tool(i, k).p_WT, track.tool(i, k).tissue_N);
    }
    return presses.map();
}

core::Result<std::vector<PalpationOutcome>> palpationOutcomes(const scoring::SessionTrace& trace) {
    std::vector<PalpationOutcome> outcomes;
    for (const scoring::TrialTrace& trial : trace.trials) {
        scoring::JudgedTrial judged = scoring::judgePalpation(trial);
        if (!judged.answer)
            return core::fail(core::ErrorCode::badInput, "trial " + std::to_string(trial.trial + 1) + ": " +
                                                             scoring::storedText({judged.reason, {}}));
        outcomes.push_back({trial.trial, trial.completed, trial.timedOut, std::move(*judged.answer)});
    }
    return outcomes;
}

core::Result<std::vector<PalpationTrialRecord>>
palpationRecord(const scoring::SessionTrace& trace, const simulation::PalpationParameters& level) {
    auto outcomes = palpationOutcomes(trace);
    CHIRON_TRY(outcomes);
    std::vector<PalpationTrialRecord> records;
    for (std::size_t i = 0; i < outcomes->size(); ++i)
        records.push_back(
            {std::move((*outcomes)[i]), mapOf(level, trace.trials[i]), lastCoverage(trace.trials[i])});
    return records;
}

} // namespace chiron::session
