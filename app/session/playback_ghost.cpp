// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/playback_ghost.h"

#include <limits>

namespace chiron::session {

namespace {

/// The displacement that moves the ghost's object to the position of the first session's object.
core::Vec3 shiftBetween(const PlaybackTrial& trial, const PlaybackTrial& ghost) {
    if (!trial.object || !ghost.object)
        return core::Vec3::Zero();
    return trial.object->p_WObject - ghost.object->p_WObject;
}

} // namespace

std::optional<GhostTool> ghostAt(const PlaybackTrack& track, const PlaybackTrack& ghost, double t_s) {
    const PlaybackTrial* mine = track.trialAt(t_s);
    if (!mine || ghost.empty())
        return std::nullopt;
    const PlaybackTrial* its = ghost.trial(mine->index);
    if (!its)
        return std::nullopt;
    GhostTool found;
    found.ownTime_s = its->start_s + (t_s - mine->start_s);
    if (found.ownTime_s > its->end_s)
        return std::nullopt;
    const PlaybackView view = ghost.at(found.ownTime_s);
    if (view.tools.empty())
        return std::nullopt;
    found.tool = view.tools.front();
    const core::Vec3 shift = shiftBetween(*mine, *its);
    found.tool.p_WT += shift;
    found.tool.p_WProxy += shift;
    return found;
}

GhostSeries ghostSeries(const PlaybackTrack& track, const PlaybackTrack& ghost) {
    constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
    GhostSeries series;
    for (const PlaybackQuantity& derived : ghost.derived)
        series.derived.push_back({derived.id, derived.unit, {}});
    /// `moment`: of the ghost; empty: a gap.
    const auto push = [&](double t_s, double tissue_N, double speed_m_per_s,
                          std::optional<std::size_t> moment) {
        series.t_s.push_back(t_s);
        series.tissue_N.push_back(tissue_N);
        series.speed_m_per_s.push_back(speed_m_per_s);
        for (std::size_t k = 0; k < ghost.derived.size(); ++k)
            series.derived[k].values.push_back(moment ? ghost.derived[k].values[*moment] : kGap);
    };
    for (std::size_t k = 0; k < track.trials.size(); ++k) {
        const PlaybackTrial& mine = track.trials[k];
        const PlaybackTrial* its = ghost.trial(mine.index);
        if (!its || ghost.empty())
            continue;
        const double until_s = k + 1 < track.trials.size() ? track.trials[k + 1].start_s : track.duration_s;
        double last_s = mine.start_s;
        for (std::size_t i = ghost.indexAt(its->start_s); i < ghost.moments.size(); ++i) {
            const double own_s = ghost.moments[i].t_s;
            const double t_s = mine.start_s + (own_s - its->start_s);
            if (own_s < its->start_s)
                continue;
            if (own_s > its->end_s || t_s > until_s)
                break;
            push(t_s, ghost.tool(i, 0).tissue_N.norm(), ghost.tool(i, 0).speed_m_per_s, i);
            last_s = t_s;
        }
        push(last_s, kGap, kGap, std::nullopt);
    }
    return series;
}

} // namespace chiron::session
