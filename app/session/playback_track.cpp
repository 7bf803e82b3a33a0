// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/playback_track.h"

#include <algorithm>

namespace chiron::session {

namespace {

PlaybackTool between(const PlaybackTool& a, const PlaybackTool& b, double part) {
    PlaybackTool tool = a;
    tool.p_WT = a.p_WT + part * (b.p_WT - a.p_WT);
    tool.p_WProxy = a.p_WProxy + part * (b.p_WProxy - a.p_WProxy);
    tool.q_WT = a.q_WT.slerp(part, b.q_WT);
    tool.jaw_rad = a.jaw_rad + part * (b.jaw_rad - a.jaw_rad);
    return tool;
}

} // namespace

std::size_t PlaybackTrack::indexAt(double t_s) const noexcept {
    const auto after =
        std::upper_bound(moments.begin(), moments.end(), t_s,
                         [](double t, const PlaybackMoment& moment) { return t < moment.t_s; });
    return after == moments.begin() ? 0 : static_cast<std::size_t>(after - moments.begin()) - 1;
}

PlaybackView PlaybackTrack::at(double t_s) const {
    PlaybackView view;
    if (empty())
        return view;
    const std::size_t i = indexAt(t_s);
    view.moment = moments[i];
    const bool last = i + 1 == moments.size();
    const double step = last ? 0.0 : moments[i + 1].t_s - moments[i].t_s;
    const double part = step > 0.0 ? std::clamp((t_s - moments[i].t_s) / step, 0.0, 1.0) : 0.0;
    // The object jumps from one trial to the next, so nothing is interpolated across.
    const bool joined = !last && moments[i + 1].trial == moments[i].trial;
    for (int k = 0; k < toolCount; ++k)
        view.tools.push_back(joined && part > 0.0 ? between(tool(i, k), tool(i + 1, k), part) : tool(i, k));
    view.moment.t_s = std::clamp(t_s, moments.front().t_s, moments.back().t_s);
    if (const PlaybackTrial* shown = trial(view.moment.trial))
        view.object = shown->object;
    for (const PlaybackQuantity& each : quantities)
        view.quantities.push_back(each.values[i]);
    return view;
}

const PlaybackTrial* PlaybackTrack::trialAt(double t_s) const noexcept {
    const PlaybackTrial* found = nullptr;
    for (const PlaybackTrial& trial : trials) {
        if (trial.start_s <= t_s)
            found = &trial;
    }
    return found;
}

const PlaybackTrial* PlaybackTrack::trial(int index) const noexcept {
    const auto found = std::find_if(trials.begin(), trials.end(),
                                    [index](const PlaybackTrial& trial) { return trial.index == index; });
    return found == trials.end() ? nullptr : &*found;
}

double PlaybackTrack::timeOfTick(std::uint64_t tick) const noexcept {
    if (empty())
        return 0.0;
    const auto found =
        std::lower_bound(moments.begin(), moments.end(), tick,
                         [](const PlaybackMoment& moment, std::uint64_t t) { return moment.tick < t; });
    return found == moments.end() ? moments.back().t_s : found->t_s;
}

std::uint64_t PlaybackTrack::tickAt(double t_s) const noexcept {
    return empty() ? 0 : moments[indexAt(t_s)].tick;
}

bool PlaybackTrack::pausedAt(double t_s) const noexcept {
    return std::any_of(paused.begin(), paused.end(),
                       [t_s](const PlaybackSpan& span) { return t_s >= span.begin_s && t_s <= span.end_s; });
}

namespace {

const PlaybackQuantity* findIn(const std::vector<PlaybackQuantity>& list, std::string_view id) noexcept {
    const auto found =
        std::find_if(list.begin(), list.end(), [id](const auto& each) { return each.id == id; });
    return found == list.end() ? nullptr : &*found;
}

} // namespace

const PlaybackQuantity* PlaybackTrack::quantity(std::string_view id) const noexcept {
    return findIn(quantities, id);
}

const PlaybackQuantity* PlaybackTrack::derivedSeries(std::string_view id) const noexcept {
    return findIn(derived, id);
}

} // namespace chiron::session
