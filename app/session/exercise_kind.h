// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "core/quantity.h"
#include "core/result.h"
#include "devices/api/device_descriptor.h"
#include "devices/driver.h"
#include "mechanisms/hand_parameters.h"
#include "mechanisms/hand_strategy.h"
#include "scoring/trace.h"
#include "session/demonstration.h"
#include "session/trial_surfaces.h"
#include "simulation/scene.h"
#include "simulation/yield.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

class QJsonObject;

namespace chiron::database {
struct TrialRecord;
}

namespace chiron::psychophysics {
struct Condition;
}

namespace chiron::session {

class AnswerEvents;
class MarkSessions;
struct MomentRule;
struct SceneEvent;
struct SessionSetup;
class PlaybackTrack;

/// A scripted trainee: one strategy per tool, which moves that hand, and the parameters of the hands. With
/// several tools, the strategies share one decision model.
struct ScriptedTrainee {
    std::vector<std::unique_ptr<mechanisms::HandStrategy>> strategies;
    mechanisms::HandParameters hand;
};

/// A trainee with one hand.
inline ScriptedTrainee oneHanded(std::unique_ptr<mechanisms::HandStrategy> strategy,
                                 const mechanisms::HandParameters& hand) {
    ScriptedTrainee trainee;
    trainee.strategies.push_back(std::move(strategy));
    trainee.hand = hand;
    return trainee;
}

/// The tool that mouse and keyboard move: a point, an endoscope, or the graspers of a laparoscopy, one at a
/// time.
using PointerTool = devices::ToolShape;

/// The tools of a level and the hands that hold them: tool = hand · perHand + place in the hand.
struct LevelTools {
    int count = 1; ///< 1..core::kMaxTools
    /// More than one for fingers on one device.
    int perHand = 1;
    double spacing_m = 0.018; ///< from one tool of a hand to the next, along x_T
    /// The largest opening of a hand's jaw, if its tool is a point with a jaw (mouse and keyboard); 0: no
    /// jaw.
    double widestJaw_rad = 0.0;
};

/// What the mark of a trial ("here it is") means.
enum class MarkRole {
    answers,      ///< it is the answer; the trial ends by something else
    endsTrial,    ///< it is the answer and ends the trial
    oneOfSeveral, ///< by itself it is not the answer
};

/// How the supervisor caps what a session commands, in addition to the largest force.
struct SessionCaps {
    /// Of the torque; the default is the site's (models.md §5), for an exercise that commands none.
    double torque_Nm = 0.150;
    /// SafetySettings::capKnee. 0: a force is cut off at the cap, so that all smaller forces are rendered
    /// unchanged.
    double knee = 0.0;
};

/// What a scripted operator holds.
struct HeldDevices {
    std::string_view mechanism; ///< kinematics id, one of ExerciseKind::mechanisms()
    /// The positions of the bases in W, one per tool. Other than those of toolPlace() only if
    /// operatorsKnowTheirPlace().
    std::span<const devices::WorkspaceMapping> places;
};

/// A metric whose value a level limits: by a pass mark, and by a limit of the level itself if it has one.
struct LimitedMetric {
    std::string_view metric; ///< id
    /// The level's own limit, in the metric's unit; empty: only a pass mark limits it.
    std::optional<double> own{};
};

/// ExerciseKind::yieldWords of an exercise that acts on tissue.
inline constexpr std::string_view kTissueGaveWay = "tissue gave way";

/// Kinematics id of the mechanism used where no other is requested: P2's gimbal.
inline constexpr std::string_view kUsualMechanism = devices::kGimbalHprd;
inline constexpr std::array<std::string_view, 1> kUsualMechanisms{kUsualMechanism};

/// An exercise: its scene, its scripted operators and its truth. A new exercise adds a class and one line in
/// app/exercises/exercise_catalogue.h. Stateless.
class ExerciseKind {
public:
    ExerciseKind() = default;
    ExerciseKind(const ExerciseKind&) = delete;
    ExerciseKind& operator=(const ExerciseKind&) = delete;
    virtual ~ExerciseKind() = default;

    virtual std::string_view id() const noexcept = 0;
    /// True if only studies present it: it is in no catalogue and has no levels among which a person could
    /// choose.
    virtual bool onlyInStudies() const noexcept { return false; }
    /// The simulated mechanisms (kinematics ids) on which the exercise can be done, at least one; the usual
    /// one comes first. Static data.
    virtual std::span<const std::string_view> mechanisms() const noexcept { return kUsualMechanisms; }
    /// The one that a scripted operator holds where no other is requested.
    std::string_view mechanism() const noexcept { return mechanisms().front(); }
    /// If a mark ends the trial, a trace file without trial numbers ends at its first mark. If a mark is the
    /// answer, so is the last position of a trace that ends within a trial; otherwise that trial has no end.
    virtual MarkRole markRole() const noexcept { return MarkRole::answers; }
    virtual LevelTools tools(const catalogue::ExerciseLevel&) const { return {}; }
    int toolCount(const catalogue::ExerciseLevel& level) const { return tools(level).count; }
    /// The default position of an instrument's device base in W: its entry point in the abdominal wall.
    virtual devices::WorkspaceMapping toolPlace(const catalogue::ExerciseLevel&, int) const { return {}; }
    /// Where the tip of a tool whose workspace is at `place` starts, m, W: for mouse and keyboard, and for a
    /// simulated mechanism that holds an endoscope. Of a point only the height counts. Empty: the driver's
    /// own start.
    virtual std::optional<core::Vec3> toolStart_W(const catalogue::ExerciseLevel&,
                                                  const devices::WorkspaceMapping& /*place*/) const {
        return {};
    }
    /// The scene's values in `SceneOutput::quantities`, in this order; they are recorded with the session. At
    /// most core::kMaxQuantities.
    virtual std::vector<core::QuantityDescription> quantities(const catalogue::ExerciseLevel&) const {
        return {};
    }
    /// True if the energy balance is recorded (TickHeader::energySupplied_J, energyStored_J) and plotted in
    /// playback.
    virtual bool recordsEnergy(const catalogue::ExerciseLevel&) const { return false; }
    /// The way in which mouse and keyboard move the tool: as a point, or as an endoscope that is advanced
    /// along its axis and turned.
    virtual PointerTool pointerTool() const noexcept { return PointerTool::point; }
    /// Makes the scene only from data stored with the session, including those of its devices, so that a
    /// replay makes the same scene.
    virtual std::unique_ptr<simulation::IScene> makeScene(const SessionSetup& setup) const = 0;
    /// The law by which the touched tissue gives way; the default never does.
    virtual simulation::YieldLaw yieldLaw(const catalogue::ExerciseLevel&) const { return {}; }
    /// What happened when it did, in the English of the command line.
    virtual std::string_view yieldWords() const noexcept { return kTissueGaveWay; }
    /// Makes a scripted operator.
    /// Errors: notFound naming the operators that exist.
    virtual core::Result<ScriptedTrainee> makeOperator(const catalogue::ExerciseLevel& level,
                                                       const std::string& name, std::uint64_t seed,
                                                       const HeldDevices& held) const = 0;
    /// True if its scripted hands convert targets from W to D, so that a device's base can be mounted
    /// anywhere. Otherwise they assume that D equals W.
    virtual bool operatorsKnowTheirPlace() const noexcept { return false; }
    virtual std::vector<std::string> operatorNames() const = 0;
    /// Seed of what people watch before they train, of any level: one with which the expert passes it
    /// (test_demonstrations), because experts fail now and then, and a demonstration shows how it is done.
    virtual std::uint64_t demonstrationSeed() const noexcept { return 1; }
    virtual int trialCount(const catalogue::ExerciseLevel& level) const = 0;
    virtual double forceLimit_N(const catalogue::ExerciseLevel& level) const = 0;
    /// The metrics of its own whose values a level limits, in addition to the force on the tissue, in the
    /// order in which people are told of them.
    virtual std::vector<LimitedMetric> limitedMetrics(const catalogue::ExerciseLevel&) const { return {}; }
    virtual SessionCaps caps(const catalogue::ExerciseLevel&) const { return {}; }
    /// The longest duration of a session of this level without pauses, in ticks; a scripted run stops there.
    virtual std::uint64_t tickLimit(const catalogue::ExerciseLevel& level) const = 0;
    /// Adds the truth of a trial (from content and seed) and the object that its mark touched.
    virtual void addTruth(const catalogue::ExerciseLevel& level, std::uint64_t seed,
                          scoring::TrialTrace& trial) const = 0;
    /// The geometry that could be touched in each trial, for playback; the same geometry as the felt one.
    virtual std::unique_ptr<TrialSurfaces> makeSurfaces(const catalogue::ExerciseLevel& level,
                                                        std::uint64_t seed) const = 0;
    /// The events that its scene has beside core::event_bits, in the order in which one tick has them.
    virtual std::span<const SceneEvent> sceneEvents() const noexcept;
    /// True if addMarks() needs the trace, which then comes from the same pass as the track.
    virtual bool marksFromTrace() const noexcept { return false; }
    /// Adds to a track the marks that need the whole trial: outcomes of answers, and events that the scores
    /// count; names the stages that the track's marks begin. Uses the same judgement as the scores. Marks
    /// stay in the order of time. `trace` is null unless marksFromTrace().
    /// Errors: a trace that cannot be scored.
    virtual core::Result<void> addMarks(const SessionSetup&, const scoring::SessionTrace* /*trace*/,
                                        PlaybackTrack&) const {
        return {};
    }
    /// Adds the outcome of a trial's answer as events of its session. Uses the same judgement as the scores.
    virtual void addAnswerEvents(const scoring::TrialTrace&, const database::TrialRecord&,
                                 AnswerEvents&) const {}
    /// Adds truth to the stored data of a trial, in addition to TrialTrace::truth.
    virtual void storeTruth(const scoring::TrialTrace&, QJsonObject& /*truth*/) const {}
    /// Who does this level in the demonstration site.
    virtual DemoPart demoPart(int level) const { return {.ofWhoCan = level <= 2, .ofWhoLearns = level == 1}; }
    /// The content that the demonstration site shows of it: columns of its table, a picture of its operators,
    /// a report.
    virtual Demonstration demonstration() const { return {}; }
    /// The rules that locate the worst moment of the exercise's own metrics. For each metric, the first rule
    /// that names it applies.
    virtual std::vector<MomentRule> momentRules() const;
    /// How deep the instrument was in the body at a time of the track, m, along its own way in; empty if the
    /// exercise measures no such depth or the recording does not tell it.
    virtual std::optional<double> depthAt_m(const PlaybackTrack&, double /*t_s*/) const { return {}; }
    /// The exercise's support for studies whose answers are marks; null if it has none or not for this
    /// condition.
    virtual const MarkSessions* markSessions(const psychophysics::Condition&) const { return nullptr; }
};

/// All exercises that can be run, including those used only by studies.
std::span<const ExerciseKind* const> exerciseKinds();
/// The ids of the exercises for which `holds` is true, in the same order, as "a, b, c".
std::string idsOfKinds(bool (*holds)(const ExerciseKind&));

/// The exercise with this id.
/// Errors: notFound naming the exercises that exist.
core::Result<const ExerciseKind*> exerciseKind(std::string_view id);

/// ExerciseKind::onlyInStudies of the exercise with this id; false for an unknown exercise.
bool isOnlyInStudies(std::string_view exercise) noexcept;

/// ExerciseKind::yieldWords of the exercise with this id; kTissueGaveWay for an unknown exercise.
std::string_view yieldWords(std::string_view exercise) noexcept;

} // namespace chiron::session
