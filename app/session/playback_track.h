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

/// One tool at one sample of a track. Everything in W; forces on the tool.
struct PlaybackTool {
    core::Vec3 p_WT = core::Vec3::Zero();     ///< m, where the hand was
    core::Vec3 p_WProxy = core::Vec3::Zero(); ///< m, at the surface while in contact
    core::Quat q_WT = core::Quat::Identity();
    core::Vec3 tissue_N = core::Vec3::Zero(); ///< the largest tissue force of the sample's ticks: no peak is lost
    double commanded_N = 0.0;                 ///< largest norm of the ticks
    double measured_N = 0.0;                  ///< the same; means something if the track's `measures`
    double speed_m_per_s = 0.0;               ///< over 40 ms
    double jaw_rad = 0.0;
};

/// What a sample's ticks share. A sample stands for up to PlaybackTrack::kTicksPerSample ticks and has the pose of the
/// last of them.
struct PlaybackMoment {
    double t_s = 0.0;       ///< device time since the first frame, ascending
    std::uint64_t tick = 0; ///< executed ticks
    std::uint16_t trial = 0;
    core::TrialPhase phase = core::TrialPhase::idle;
    core::ForceState force = core::ForceState::off;
    bool paused = false;
};

/// One trial on the track's time. A trial that was stopped has neither mark, completion nor time-out and ends with the recording.
struct PlaybackTrial {
    int index = 0; ///< from 0
    double start_s = 0.0;
    double end_s = 0.0;
    bool marked = false;
    bool timedOut = false;
    bool completed = false;      ///< the procedure was done to its end
    bool failed = false;         ///< it could not be done any more (torn)
    bool endedInContact = false; ///< tissue force over 0.02 N at its end, as scoring asks of a mark
    core::Vec3 p_WEnd = core::Vec3::Zero(); ///< tool 0 at the mark, or where it stood at the end
    std::optional<TrialObject> object;      ///< the truth
};

/// Where what some metrics measure sample by sample was largest in a trial, among the samples that they take: exact, at the recording's
/// own rate, where a track has one sample in four.
struct PlaybackPeak {
    std::vector<std::string> metrics; ///< ids
    int trial = 0;
    double t_s = 0.0;
    double value = 0.0; ///< in `unit`, that of the metrics
    std::string unit;
};

/// How an instrument lay in a canal, one value a moment of the track, not a number outside of a trial. Empty: there is no canal, or the
/// recording does not tell how the instrument was turned.
struct PlaybackCanal {
    std::vector<double> offset_m;      ///< of the tip from the centre-line
    std::vector<double> alignment_rad; ///< between instrument and centre-line
    bool empty() const noexcept { return offset_m.empty(); }
};

/// What an exercise makes of a whole recording for its own screens and reports. Never changed once it is in a track, whose copies share it.
class PlaybackOfExercise {
public:
    virtual ~PlaybackOfExercise() = default;

protected:
    PlaybackOfExercise() = default;
    PlaybackOfExercise(const PlaybackOfExercise&) = default;
    PlaybackOfExercise& operator=(const PlaybackOfExercise&) = default;
};

/// One of the scene's quantities as recorded (ExerciseKind::quantities, and "energy_supplied_J", "energy_stored_J" where the
/// books of energy were kept), at each moment of the track.
struct PlaybackQuantity {
    std::string id;
    std::string unit; ///< SI
    std::vector<double> values; ///< one a moment: that of its last tick
};

struct PlaybackSpan {
    double begin_s = 0.0;
    double end_s = 0.0;
};

/// What is asked of the track at a time between two samples.
struct PlaybackView {
    PlaybackMoment moment;
    std::vector<PlaybackTool> tools;
    std::optional<TrialObject> object; ///< of the trial at that time
    std::vector<double> quantities; ///< as PlaybackTrack::quantities, of the earlier sample
};

/// A stored session made ready for playback: built once on a worker (SessionView::track), then a value that any one
/// thread reads without a database. 250 samples a second; about 200 bytes a sample and tool.
class PlaybackTrack {
public:
    static constexpr int kTicksPerSample = 4; ///< 1 kHz -> 250 Hz

    database::SessionId session = 0;
    std::string exercise;
    int level = 1;
    bool felt = false;         ///< device class: force was rendered, or only shown
    bool measures = false;     ///< the device measured force
    double forceLimit_N = 0.0; ///< of the level, as people meet it (levelLimits)
    int toolCount = 0;
    std::vector<PlaybackMoment> moments;
    std::vector<PlaybackTool> tools; ///< toolCount of each moment, one moment after the other
    std::vector<PlaybackTrial> trials;
    std::vector<PlaybackSpan> paused; ///< left out of every metric
    std::vector<PlaybackMark> marks;  ///< by time
    std::vector<PlaybackPeak> peaks;  ///< of those metrics for which the exercise tells it
    std::vector<PlaybackQuantity> quantities; ///< those that were recorded; none for exercises without
    double duration_s = 0.0;          ///< device time of the last frame
    PlaybackCanal canal;
    std::shared_ptr<const PlaybackOfExercise> own; ///< null: the exercise has nothing of its own, or the recording does not tell it

    bool empty() const noexcept { return moments.empty(); }
    /// `own`, for those who know what it is; null where it is nothing of the kind.
    template <class Own> const Own* of() const noexcept { return dynamic_cast<const Own*>(own.get()); }
    /// Index of the last sample at or before `t_s`; 0 before the first. Undefined on an empty track.
    std::size_t indexAt(double t_s) const noexcept;
    const PlaybackTool& tool(std::size_t moment, int tool) const noexcept {
        return tools[moment * static_cast<std::size_t>(toolCount) + static_cast<std::size_t>(tool)];
    }
    /// Poses interpolated between the two samples around `t_s` (positions linearly, orientation along the arc), forces
    /// and state of the earlier one, so that nothing is shown that was not recorded. Clamped to the track. Logarithmic.
    PlaybackView at(double t_s) const;
    /// The trial that runs at `t_s`, or the last one before it; nothing before the first.
    const PlaybackTrial* trialAt(double t_s) const noexcept;
    const PlaybackTrial* trial(int index) const noexcept;
    double timeOfTick(std::uint64_t tick) const noexcept; ///< of the first sample that reaches the tick; clamped
    std::uint64_t tickAt(double t_s) const noexcept;
    bool pausedAt(double t_s) const noexcept;
    const PlaybackQuantity* quantity(std::string_view id) const noexcept; ///< null where it was not recorded
};

} // namespace chiron::session
