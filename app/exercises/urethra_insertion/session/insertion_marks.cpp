// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/session/insertion_marks.h"

#include "curriculum/exercises/urethra_insertion/scoring/canal_series.h"
#include "curriculum/exercises/urethra_insertion/scoring/insertion_events.h"
#include "curriculum/exercises/urethra_insertion/scoring/insertion_moments.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "scoring/trace_grid.h"

#include <algorithm>

namespace chiron::session {

namespace {

/// The event of a tick and its sample can differ in time by one packet.
constexpr double kNear_s = 0.002;

void addEvents(PlaybackTrack& track, int trial, const PlaybackMarkKind& kind,
               const std::vector<scoring::InsertionEvent>& events, bool mayBeCritical = false) {
    for (const scoring::InsertionEvent& event : events) {
        PlaybackMark mark;
        mark.t_s = event.begin_s;
        mark.end_s = event.end_s;
        mark.tick = track.tickAt(event.begin_s);
        mark.kind = kind;
        mark.trial = trial;
        mark.value = event.value;
        mark.critical = mayBeCritical && scoring::isCritical(event);
        track.marks.push_back(std::move(mark));
    }
}

/// The words of the stages that a trial went through, without waiting outside and without the end: one for
/// each stageChanged mark. Every trial is outside before its first sample; a trial that begins with the beak
/// inside changes its stage at that sample.
std::vector<std::string> stagesOf(const scoring::InsertionSeries& series) {
    std::vector<std::string> stages;
    auto last = simulation::ProcedureStage::outside;
    for (const std::uint8_t value : series.stage) {
        const auto stage = static_cast<simulation::ProcedureStage>(value);
        if (stage != last && stage != simulation::ProcedureStage::completed)
            stages.emplace_back(scoring::stageName(stage));
        last = stage;
    }
    return stages;
}

double seenUntil(const scoring::InsertionSeries& series, double t_s) {
    return static_cast<double>(std::count_if(series.landmarkSeen_s.begin(), series.landmarkSeen_s.end(),
                                             [t_s](double seen_s) { return seen_s <= t_s + kNear_s; }));
}

void completeMarks(PlaybackTrack& track, int trial, const scoring::InsertionSeries& series) {
    const std::vector<std::string> stages = stagesOf(series);
    const auto changes = static_cast<std::size_t>(
        std::count_if(track.marks.begin(), track.marks.end(), [trial](const PlaybackMark& mark) {
            return mark.trial == trial && mark.kind == mark_kinds::kStageChanged;
        }));
    std::size_t change = 0;
    for (PlaybackMark& mark : track.marks) {
        if (mark.trial != trial)
            continue;
        if (mark.kind == mark_kinds::kStageChanged && changes == stages.size())
            mark.detail = stages[change++];
        if (mark.kind == mark_kinds::kLandmarkSeen)
            mark.value = seenUntil(series, mark.t_s);
    }
}

/// Tissue that gave way during a trauma that is already a critical error does not count as a second error.
void countOnce(PlaybackTrack& track, int trial, const std::vector<scoring::InsertionEvent>& trauma) {
    for (PlaybackMark& mark : track.marks)
        if (mark.kind == mark_kinds::kYielded && mark.trial == trial)
            mark.critical =
                mark.critical &&
                std::none_of(trauma.begin(), trauma.end(), [&mark](const scoring::InsertionEvent& event) {
                    return scoring::isCritical(event) && event.begin_s - kNear_s <= mark.t_s &&
                           mark.t_s <= event.end_s + kNear_s;
                });
}

/// Handles only gates that a single sample can exceed: a mean over the trial has no moment.
void addStretches(PlaybackTrack& track, const scoring::TrialTrace& trial,
                  std::span<const scoring::Gate> gates) {
    for (const scoring::Gate& gate : gates) {
        if (!gate.maximum)
            continue;
        if (gate.metric == "offset_max")
            addEvents(track, trial.trial, mark_kinds::kOffCentre,
                      scoring::stretchesOver(trial, scoring::InsertionQuantity::offset, *gate.maximum));
        if (gate.metric == "torque_max")
            addEvents(track, trial.trial, mark_kinds::kOverTorque,
                      scoring::stretchesOver(trial, scoring::InsertionQuantity::torque, *gate.maximum));
    }
}

void addPeaks(PlaybackTrack& track, const scoring::TrialTrace& trial) {
    for (const scoring::InsertionQuantity quantity : scoring::insertionQuantities())
        if (const auto largest = scoring::largestOf(trial, quantity)) {
            const auto metrics = scoring::metricsOf(quantity);
            track.peaks.push_back({{metrics.begin(), metrics.end()},
                                   trial.trial,
                                   largest->begin_s,
                                   scoring::inMetricUnit(quantity, largest->value),
                                   scoring::metricUnitOf(quantity)});
        }
}

} // namespace

core::Result<void> addInsertionMarks(PlaybackTrack& track, const scoring::SessionTrace& trace,
                                     std::span<const scoring::Gate> gates, bool traumaIsCritical) {
    const auto scored = scoring::onStoredGrids(trace);
    CHIRON_TRY(scored);
    for (const scoring::TrialTrace& trial : scored->trials) {
        const scoring::InsertionSeries* series = scoring::insertionOf(trial);
        if (series == nullptr)
            continue;
        completeMarks(track, trial.trial, *series);
        const scoring::InsertionEvents events = scoring::insertionEvents(trial);
        addEvents(track, trial.trial, mark_kinds::kTrauma, events.trauma, traumaIsCritical);
        if (traumaIsCritical)
            countOnce(track, trial.trial, events.trauma);
        addEvents(track, trial.trial, mark_kinds::kReversal, events.reversals);
        addStretches(track, trial, gates);
        addPeaks(track, trial);
    }
    std::stable_sort(track.marks.begin(), track.marks.end(),
                     [](const PlaybackMark& a, const PlaybackMark& b) { return a.t_s < b.t_s; });
    return {};
}

} // namespace chiron::session
