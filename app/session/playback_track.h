// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/session_state.h"
#include "core/tool_state.h"
#include "database/actor.h"
#include "session/playback_mark.h"
#include "session/trial_surfaces.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::session {

/// One tool at one sample of a track. Forces act on the tool.
/// Frame: W.
struct PlaybackTool {
    core::Vec3 p_WT = core::Vec3::Zero();     ///< m, position of the hand
    core::Vec3 p_WProxy = core::Vec3::Zero(); ///< m, at the surface while in contact
    core::Quat q_WT = core::Quat::Identity();
    core::Vec3 tissue_N = core::Vec3::Zero(); ///< largest tissue force of the sample's ticks, so that no peak
                                              ///< is lost
    double commanded_N = 0.0;                 ///< largest norm over the ticks
    double measured_N = 0.0;                  ///< the same; valid only if the track's `measures`
    double speed_m_per_s = 0.0;               ///< over 40 ms
    double jaw_rad = 0.0;
};

/// The data that the ticks of a sample share. A sample covers up to PlaybackTrack::kTicksPerSample ticks and
/// has the pose of the last of them.
struct PlaybackMoment {
    double t_s = 0.0;       ///< device time since the first frame, ascending
    std::uint64_t tick = 0; ///< executed ticks
    std::uint16_t trial = 0;
    core::TrialPhase phase = core::TrialPhase::idle;
    core::ForceState force = core::ForceState::off;
    bool paused = false;
};

/// One trial on the track's time. A trial that was stopped has no mark, completion or time-out and ends with
/// the recording.
struct PlaybackTrial {
    int index = 0; ///< from 0
    double start_s = 0.0;
    double end_s = 0.0;
    bool marked = false;
    bool timedOut = false;
    bool completed = false;      ///< the procedure was completed
    bool failed = false;         ///< the trial could not be continued (torn)
    bool endedInContact = false; ///< tissue force over 0.02 N at its end, as the scoring requires of a mark
    core::Vec3 p_WEnd = core::Vec3::Zero(); ///< position of tool 0 at the mark, or at the end
    std::optional<TrialObject> object;      ///< the truth
};

/// The moment of a trial at which the quantity behind some metrics was largest, among the samples that these
/// metrics use. It is exact at the recording's own rate, whereas a track has one sample in four.
struct PlaybackPeak {
    std::vector<std::string> metrics; ///< ids
    int trial = 0;
    double t_s = 0.0;
    double value = 0.0; ///< in `unit`, the unit of the metrics
    std::string unit;
};

/// Data that an exercise derives from a whole recording for its own screens and reports. They never change
/// once they are in a track, because copies of the track share them.
class PlaybackOfExercise {
public:
    virtual ~PlaybackOfExercise() = default;

protected:
    PlaybackOfExercise() = default;
    PlaybackOfExercise(const PlaybackOfExercise&) = default;
    PlaybackOfExercise& operator=(const PlaybackOfExercise&) = default;
};

/// One of the recorded quantities of the scene (ExerciseKind::quantities, and "energy_supplied_J",
/// "energy_stored_J" if the energy balance was recorded), or a series derived from the recording, at each
/// moment of the track.
struct PlaybackQuantity {
    std::string id;
    std::string unit;           ///< SI
    std::vector<double> values; ///< one per moment: the value of its last tick
};

struct PlaybackSpan {
    double begin_s = 0.0;
    double end_s = 0.0;
};

/// The state of the track at a time between two samples.
struct PlaybackView {
    PlaybackMoment moment;
    std::vector<PlaybackTool> tools;
    std::optional<TrialObject> object; ///< of the trial at that time
    std::vector<double> quantities;    ///< in the order of PlaybackTrack::quantities, from the earlier sample
};

/// A stored session prepared for playback. It is built once on a worker (SessionView::track); afterwards it
/// is a plain value that needs no database. It has 250 samples per second and takes about 200 bytes per
/// sample and tool.
/// Thread: any one.
class PlaybackTrack {
public:
    static constexpr int kTicksPerSample = 4; ///< 1 kHz -> 250 Hz

    database::SessionId session = 0;
    std::string exercise;
    int level = 1;
    bool felt = false;         ///< device class: force was rendered, or only shown
    bool measures = false;     ///< the device measured force
    double forceLimit_N = 0.0; ///< of the level, as shown to people (levelLimits)
    int toolCount = 0;
    std::vector<PlaybackMoment> moments;
    std::vector<PlaybackTool> tools; ///< toolCount entries for each moment, one moment after the other
    std::vector<PlaybackTrial> trials;
    std::vector<PlaybackSpan> paused;         ///< excluded from every metric
    std::vector<PlaybackMark> marks;          ///< by time
    std::vector<PlaybackPeak> peaks;          ///< of the metrics for which the exercise provides them
    std::vector<PlaybackQuantity> quantities; ///< those that were recorded
    double duration_s = 0.0;                  ///< device time of the last frame
    /// Series that the exercise derives from the recording, with a value for each moment, NaN outside of a
    /// trial; none if the recording does not contain what they need.
    std::vector<PlaybackQuantity> derived;
    /// Null if the exercise has no data of its own, or the recording does not contain them.
    std::shared_ptr<const PlaybackOfExercise> own;

    bool empty() const noexcept { return moments.empty(); }
    /// `own` as the type that the caller expects; null if it has another type.
    template <class Own> const Own* of() const noexcept { return dynamic_cast<const Own*>(own.get()); }
    /// Index of the last sample at or before `t_s`; 0 before the first. Undefined on an empty track.
    std::size_t indexAt(double t_s) const noexcept;
    const PlaybackTool& tool(std::size_t moment, int tool) const noexcept {
        return tools[moment * static_cast<std::size_t>(toolCount) + static_cast<std::size_t>(tool)];
    }
    /// Interpolates the poses between the two samples around `t_s` (positions linearly, orientation along the
    /// arc); forces and state are those of the earlier sample, so that nothing is shown that was not
    /// recorded. `t_s` is clamped to the track. Takes logarithmic time.
    PlaybackView at(double t_s) const;
    /// The trial at `t_s`, or the last one before it; null before the first.
    const PlaybackTrial* trialAt(double t_s) const noexcept;
    const PlaybackTrial* trial(int index) const noexcept;
    double timeOfTick(std::uint64_t tick) const noexcept; ///< of the first sample that includes the tick;
                                                          ///< clamped
    std::uint64_t tickAt(double t_s) const noexcept;
    bool pausedAt(double t_s) const noexcept;
    const PlaybackQuantity* quantity(std::string_view id) const noexcept; ///< null if it was not recorded
    const PlaybackQuantity* derivedSeries(std::string_view id) const noexcept; ///< null if there is none
};

} // namespace chiron::session
