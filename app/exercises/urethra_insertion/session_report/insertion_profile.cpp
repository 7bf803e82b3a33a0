// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/session_report/insertion_profile.h"

#include "app/exercises/urethra_insertion/session/playback_insertion.h"
#include "curriculum/exercises/urethra_insertion/scoring/canal_series.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace chiron::session_report {

namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr int kBefore_mm = 10; // length of the beak of an endoscope

void raise(double& most, double value) {
    if (!(most >= value))
        most = value;
}

/// Collects samples into the largest value of each millimetre.
class ProfileMaker {
public:
    void add(simulation::ProcedureStage stage, double depth_m, double offset_m, double alignment_rad) {
        const bool in =
            stage == simulation::ProcedureStage::outside || stage == simulation::ProcedureStage::insertion;
        const bool out = stage == simulation::ProcedureStage::withdrawal;
        const double depth_mm = std::floor(depth_m * 1e3);
        if ((!in && !out) || !std::isfinite(depth_m) || depth_mm < -kBefore_mm || depth_mm > kDeepest_mm)
            return;
        const auto bin = static_cast<std::size_t>(depth_mm + kBefore_mm);
        grow(bin + 1);
        raise((in ? m_profile.offsetIn_mm : m_profile.offsetOut_mm)[bin], offset_m * 1e3);
        raise((in ? m_profile.alignmentIn_deg : m_profile.alignmentOut_deg)[bin], alignment_rad * kDegrees);
    }
    report::InsertionProfile& profile() { return m_profile; }

private:
    static constexpr double kDeepest_mm = 300.0; // no urethra is longer

    void grow(std::size_t count) {
        for (std::size_t i = m_profile.depth_mm.size(); i < count; ++i)
            m_profile.depth_mm.push_back(static_cast<double>(i) - kBefore_mm + 0.5);
        for (auto* values : {&m_profile.offsetIn_mm, &m_profile.offsetOut_mm, &m_profile.alignmentIn_deg,
                             &m_profile.alignmentOut_deg})
            values->resize(m_profile.depth_mm.size(), kNothing);
    }

    report::InsertionProfile m_profile;
};

void addFacts(report::InsertionProfile& profile, double bend_m, double length_m, double goal_m,
              const std::vector<double>& seen_s) {
    profile.bend_mm = bend_m * 1e3;
    profile.neck_mm = length_m * 1e3;
    profile.goal_mm = goal_m * 1e3;
    profile.landmarks = static_cast<int>(seen_s.size());
    profile.landmarksSeen = static_cast<int>(
        std::count_if(seen_s.begin(), seen_s.end(), [](double t_s) { return std::isfinite(t_s); }));
}

} // namespace

std::optional<report::InsertionProfile> insertionProfileOf(const scoring::SessionTrace& trace) {
    ProfileMaker maker;
    bool any = false;
    for (const scoring::TrialTrace& trial : trace.trials) {
        const scoring::InsertionSeries* found = scoring::insertionOf(trial);
        if (found == nullptr || trial.tools.empty())
            continue;
        const scoring::InsertionSeries& series = *found;
        if (!any)
            addFacts(maker.profile(), series.bend_m, series.length_m, series.goal_m, series.landmarkSeen_s);
        any = true;
        const std::vector<std::uint8_t>& paused = trial.tools.front().paused;
        for (std::size_t i = 0; i < series.s_m.size(); ++i)
            if (i >= paused.size() || paused[i] == 0)
                maker.add(static_cast<simulation::ProcedureStage>(series.stage[i]), series.s_m[i],
                          series.offset_m[i], series.alignment_rad[i]);
    }
    return any ? std::optional(std::move(maker.profile())) : std::nullopt;
}

std::optional<report::InsertionProfile> insertionProfileOf(const session::PlaybackTrack& track) {
    const auto* own = track.of<session::PlaybackInsertion>();
    if (!own)
        return std::nullopt;
    ProfileMaker maker;
    const session::PlaybackInsertion& insertion = *own;
    addFacts(maker.profile(), insertion.bend_m, insertion.length_m, insertion.goal_m,
             insertion.landmarkSeen_s);
    for (std::size_t i = 0; i < insertion.moments.size(); ++i) {
        const session::PlaybackInsertionMoment& moment = insertion.moments[i];
        if (i >= track.moments.size() || !track.moments[i].paused)
            maker.add(moment.stage, moment.depth_m, moment.offset_m, moment.alignment_rad);
    }
    return std::move(maker.profile());
}

} // namespace chiron::session_report
