// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "core/result.h"
#include "core/quantity.h"
#include "devices/api/device_descriptor.h"
#include "devices/driver.h"
#include "mechanisms/hand_parameters.h"
#include "mechanisms/hand_strategy.h"
#include "scoring/trace.h"
#include "session/demonstration.h"
#include "session/trial_surfaces.h"
#include "simulation/scene.h"
#include "simulation/yield.h"

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

namespace chiron::scoring {
struct TraceColumns;
struct TraceRow;
}

namespace chiron::session {

class AnswerEvents;
class MarkSessions;
struct MomentRule;
struct SessionSetup;
class PlaybackTrack;

/// A scripted trainee: what moves each hand (one a tool; of one mind where there are several), and what the hands are like.
struct ScriptedTrainee {
    std::vector<std::unique_ptr<mechanisms::HandStrategy>> strategies;
    mechanisms::HandParameters hand;
};

/// A trainee with one hand.
inline ScriptedTrainee oneHanded(std::unique_ptr<mechanisms::HandStrategy> strategy, const mechanisms::HandParameters& hand) {
    ScriptedTrainee trainee;
    trainee.strategies.push_back(std::move(strategy));
    trainee.hand = hand;
    return trainee;
}

/// What a mouse and a keyboard move: a point, an endoscope, or the graspers of a laparoscopy, one at a time.
using PointerTool = devices::ToolShape;

/// How the tools of an exercise on fingertip platforms (P3) are fingers of hands: tool = hand · perHand + finger.
struct FingersOfHand {
    int perHand = 1;
    double spacing_m = 0.018; ///< from one pad to the next, along x_T
};

/// The simulated mechanism where nothing else is asked for: P2's gimbal.
inline constexpr std::string_view kUsualMechanism = "gimbal_hprd";

/// How one kind of exercise is run: its scene, its operators and its truth. A new
/// kind adds a class and one line in app/exercises/session_catalogue.cpp. Stateless.
class ExerciseKind {
public:
    ExerciseKind() = default;
    ExerciseKind(const ExerciseKind&) = delete;
    ExerciseKind& operator=(const ExerciseKind&) = delete;
    virtual ~ExerciseKind() = default;

    virtual std::string_view id() const noexcept = 0;
    /// The simulated mechanism that a scripted operator holds: kinematics id "gimbal_hprd" (P2), "five_bar_spherical" (P1) or
    /// "fingertip_arm" (P3).
    virtual std::string_view mechanism() const noexcept { return kUsualMechanism; }
    /// All on which it can be done, the usual one (mechanism()) first.
    virtual std::vector<std::string_view> mechanisms() const { return {mechanism()}; }
    /// Whether a trace that ends within a trial means its last position as the answer. Where a mark answers nothing by itself it
    /// does not, and the trial stays without its end.
    virtual bool traceEndIsMark() const noexcept { return true; }
    /// Whether the mark of a trial ends it, so that a trace file without numbers of trials ends at its first mark.
    virtual bool markEndsTrial() const noexcept { return false; }
    /// SafetySettings::capKnee of its sessions. 0: a force is cut at the cap, so that all below it is felt as it is.
    virtual double capKnee() const noexcept { return 0.0; }
    /// How many instruments a level is done with, 1..core::kMaxTools.
    virtual int toolCount(const catalogue::ExerciseLevel&) const { return 1; }
    /// Of a kind whose mechanism is "fingertip_arm".
    virtual FingersOfHand fingers(const catalogue::ExerciseLevel&) const { return {}; }
    /// How wide the jaw of a hand opens where its tool is a point that has one (mouse and keyboard), rad; 0: no jaw.
    virtual double fingerJaw_rad(const catalogue::ExerciseLevel&) const { return 0.0; }
    /// Where the device base of an instrument stands in W when nothing else is said: its entry point in the abdomen's wall.
    virtual devices::WorkspaceMapping toolPlace(const catalogue::ExerciseLevel&, int) const { return {}; }
    /// How high above W's origin a pointer's tool begins over this place of W, metres, where there is nothing to be found on the way
    /// down; empty: as high as the driver begins.
    virtual std::optional<double> pointerStart_m(const catalogue::ExerciseLevel&, double /*x_m*/, double /*y_m*/) const { return {}; }
    /// What the scene puts into `SceneOutput::quantities`, in that order; recorded with the session. At most core::kMaxQuantities.
    virtual std::vector<core::QuantityDescription> quantities(const catalogue::ExerciseLevel&) const { return {}; }
    /// Whether the books of energy are recorded (TickHeader::energySupplied_J, energyStored_J) and plotted in playback.
    virtual bool recordsEnergy(const catalogue::ExerciseLevel&) const { return false; }
    /// How a mouse and a keyboard move the tool: a point, or an endoscope that is advanced along its axis and turned.
    virtual PointerTool pointerTool() const noexcept { return PointerTool::point; }
    /// Where the tip of an endoscope begins, m, W: of a mouse and keyboard, and of a simulated mechanism that holds one.
    virtual core::Vec3 endoscopeStart_W() const noexcept { return core::Vec3::Zero(); }
    /// From what is stored with the session alone, its devices' data included, so that a replay makes the same scene.
    virtual std::unique_ptr<simulation::IScene> makeScene(const SessionSetup& setup) const = 0;
    /// When what is touched gives way; as it stands here: never.
    virtual simulation::YieldLaw yieldLaw(const catalogue::ExerciseLevel&) const { return {}; }
    /// Failure: notFound naming the operators that exist.
    virtual core::Result<ScriptedTrainee> makeOperator(const catalogue::ExerciseLevel& level, const std::string& name,
                                                       std::uint64_t seed) const = 0;
    /// The same on a certain mechanism of mechanisms(), where that makes a difference.
    virtual core::Result<ScriptedTrainee> makeOperatorOn(std::string_view, const catalogue::ExerciseLevel& level,
                                                         const std::string& name, std::uint64_t seed) const {
        return makeOperator(level, name, seed);
    }
    /// The same with device bases that stand elsewhere than toolPlace() says, one a tool: only where operatorsKnowTheirPlace().
    virtual core::Result<ScriptedTrainee> makeOperatorAt(std::span<const devices::WorkspaceMapping>, std::string_view mechanism,
                                                         const catalogue::ExerciseLevel& level, const std::string& name,
                                                         std::uint64_t seed) const {
        return makeOperatorOn(mechanism, level, name, seed);
    }
    /// Whether its scripted hands look at W and reach in D, so that a device's base can be mounted as one likes. Others take D for W.
    virtual bool operatorsKnowTheirPlace() const noexcept { return false; }
    virtual std::vector<std::string> operatorNames() const = 0;
    virtual int trialCount(const catalogue::ExerciseLevel& level) const = 0;
    virtual double forceLimit_N(const catalogue::ExerciseLevel& level) const = 0;
    /// Limits of a level beside that of the force on the tissue: which metric should not come to more, and how much that is, N.
    virtual std::vector<std::pair<std::string_view, double>> otherLimits_N(const catalogue::ExerciseLevel&) const { return {}; }
    /// The exercise's torque cap for the supervisor; the site's default (models.md §5) where it commands no torque.
    virtual double torqueLimit_Nm(const catalogue::ExerciseLevel&) const { return 0.150; }
    /// Longest time, in ticks, that a session of this level can take without pauses: a scripted run stops there.
    virtual std::uint64_t tickLimit(const catalogue::ExerciseLevel& level) const = 0;
    /// Adds to a trial what is true of it (from content and seed) and what its mark touched.
    virtual void addTruth(const catalogue::ExerciseLevel& level, std::uint64_t seed,
                          scoring::TrialTrace& trial) const = 0;
    /// What could be touched in each trial, for playback: the geometry that was felt.
    virtual std::unique_ptr<TrialSurfaces> makeSurfaces(const catalogue::ExerciseLevel& level,
                                                        std::uint64_t seed) const = 0;
    /// Whether addMarks() needs the trace: it then is of the same pass as the track.
    virtual bool marksFromTrace() const noexcept { return false; }
    /// Adds to a track what only the whole of a trial tells: what an answer was worth, what scores count. By the same judgement as the
    /// scores. Marks stay in the order of time. `trace` is null unless marksFromTrace(). Failure: a trace that cannot be scored.
    virtual core::Result<void> addMarks(const SessionSetup&, const scoring::SessionTrace* /*trace*/, PlaybackTrack&) const { return {}; }
    /// Adds what the answer of a trial was worth, as events of its session. By the same judgement as the scores.
    virtual void addAnswerEvents(const scoring::TrialTrace&, const database::TrialRecord&, AnswerEvents&) const {}
    /// Adds to what is stored with a trial what is true of it beside TrialTrace::truth.
    virtual void storeTruth(const scoring::TrialTrace&, QJsonObject& /*truth*/) const {}
    /// The columns that an exported trace has for this exercise beside quantities and TrialTrace::truth.
    virtual void addColumns(std::span<const scoring::TrialTrace>, scoring::TraceColumns&) const {}
    /// Fills those columns that say something of the whole trial ...
    virtual void fillRowOfTrial(const scoring::TrialTrace&, scoring::TraceRow&) const {}
    /// ... and those of the sample of this row (its tool and time are set), which lies within the trial.
    virtual void fillRowOfSample(const scoring::TrialTrace&, scoring::TraceRow&) const {}
    /// Who does this level in the demonstration site.
    virtual DemoPart demoPart(int level) const { return {.ofWhoCan = level <= 2, .ofWhoLearns = level == 1}; }
    /// What the demonstration site shows of it: columns of its table, a picture of its operators, a report.
    virtual Demonstration demonstration() const { return {}; }
    /// Where its own metrics were worst. For each metric the first rule that names it decides.
    virtual std::vector<MomentRule> momentRules() const;
    /// How it serves studies whose answers are marks; null: it does not, or not this condition.
    virtual const MarkSessions* markSessions(const psychophysics::Condition&) const { return nullptr; }
};

/// Where the bases of a level's tools stand when nobody mounts them elsewhere.
std::vector<devices::WorkspaceMapping> usualPlaces(const ExerciseKind& kind, const catalogue::ExerciseLevel& level);

/// All that can be run, those of studies included.
std::span<const ExerciseKind* const> exerciseKinds();
/// The ids of those for which `holds`, in that order, as in "a, b, c".
std::string idsOfKinds(bool (*holds)(const ExerciseKind&));

/// The kind with this id. Failure: notFound naming the kinds that exist.
core::Result<const ExerciseKind*> exerciseKind(std::string_view id);

} // namespace chiron::session
