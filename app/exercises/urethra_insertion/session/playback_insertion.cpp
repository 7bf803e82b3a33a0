// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/session/playback_insertion.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace chiron::session {

namespace {

constexpr double kSameTime_s = 0.6e-6; // traces have times in whole microseconds, tracks do not

void addFacts(PlaybackInsertion& insertion, const scoring::InsertionSeries& series) {
    insertion.length_m = series.length_m;
    insertion.bend_m = series.bend_m;
    insertion.goal_m = series.goal_m;
    insertion.landmarkSeen_s = series.landmarkSeen_s;
}

/// The values of the series at `t_s`: those of its last sample that is not later.
void addMoment(PlaybackInsertionMoment& moment, const scoring::TrialTrace& trial, double t_s) {
    const std::vector<double>& times_s = trial.tools.front().t_s;
    const scoring::InsertionSeries& series = *scoring::insertionOf(trial);
    const auto after = std::upper_bound(times_s.begin(), times_s.end(), t_s + kSameTime_s);
    if (after == times_s.begin())
        return;
    const auto i = static_cast<std::size_t>(after - times_s.begin()) - 1;
    moment.stage = static_cast<simulation::ProcedureStage>(series.stage[i]);
    if (after == times_s.end() && t_s > times_s.back() + kSameTime_s)
        // The trial is over: its last stage remains, and nothing is measured.
        return;
    moment.depth_m = series.s_m[i];
    moment.offset_m = series.offset_m[i];
    moment.alignment_rad = series.alignment_rad[i];
}

} // namespace

std::uint32_t PlaybackInsertion::landmarksSeenAt(double t_s) const noexcept {
    std::uint32_t seen = 0;
    for (std::size_t i = 0; i < landmarkSeen_s.size() && i < 32; ++i)
        seen |= landmarkSeen_s[i] <= t_s ? 1u << i : 0u; // NaN: never
    return seen;
}

int PlaybackInsertion::landmarksSeen() const noexcept {
    return static_cast<int>(std::count_if(landmarkSeen_s.begin(), landmarkSeen_s.end(),
                                          [](double t) { return std::isfinite(t); }));
}

PlaybackInsertion playbackInsertionOf(const scoring::SessionTrace& trace, std::span<const double> times_s) {
    PlaybackInsertion insertion;
    insertion.moments.resize(times_s.size());
    bool first = true;
    for (const scoring::TrialTrace& trial : trace.trials) {
        const scoring::InsertionSeries* series = scoring::insertionOf(trial);
        if (series == nullptr || trial.tools.empty() || series->s_m.size() != trial.tools.front().t_s.size())
            continue;
        if (first)
            addFacts(insertion, *series);
        first = false;
        for (std::size_t i = 0; i < times_s.size(); ++i)
            addMoment(insertion.moments[i], trial, times_s[i]);
    }
    return insertion;
}

void addInsertion(PlaybackTrack& track, const scoring::SessionTrace& trace) {
    const bool any = std::any_of(trace.trials.begin(), trace.trials.end(),
                                 [](const auto& trial) { return scoring::insertionOf(trial) != nullptr; });
    if (!any)
        return;
    std::vector<double> times_s;
    times_s.reserve(track.moments.size());
    for (const PlaybackMoment& moment : track.moments)
        times_s.push_back(moment.t_s);
    auto own = std::make_shared<PlaybackInsertion>(playbackInsertionOf(trace, times_s));
    PlaybackQuantity offset{std::string(kOffsetSeries), "m", {}},
        alignment{std::string(kAlignmentSeries), "rad", {}};
    for (const PlaybackInsertionMoment& moment : own->moments) {
        offset.values.push_back(moment.offset_m);
        alignment.values.push_back(moment.alignment_rad);
    }
    track.derived = {std::move(offset), std::move(alignment)};
    track.own = std::move(own);
}

std::optional<PlaybackInsertionMoment> insertionAt(const PlaybackTrack& track, double t_s) {
    const auto* insertion = track.of<PlaybackInsertion>();
    return insertion && !track.empty() ? std::optional(insertion->moments[track.indexAt(t_s)]) : std::nullopt;
}

} // namespace chiron::session
