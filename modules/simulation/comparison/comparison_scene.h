// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/presentation_word.h"
#include "simulation/comparison/compared_object.h"
#include "simulation/comparison/comparison_parameters.h"
#include "simulation/scene.h"
#include "simulation/trial_course.h"

#include <array>
#include <cstdint>
#include <optional>

namespace chiron::simulation {

/// Indices into `SceneOutput::quantities` (comparison).
namespace comparison_quantity {
inline constexpr std::size_t kPlace = 0;       ///< touched or held place, from 1; 0: none
inline constexpr std::size_t kCandidate = 1;   ///< presented, from 1; 0: nothing yet
inline constexpr std::size_t kArrangement = 2; ///< from 1
inline constexpr std::size_t kAnswer = 3;      ///< in this trial, from 1; 0: none yet
/// Places touched in this trial (with ComparisonParameters::probeAtLeast_N), one bit each.
inline constexpr std::size_t kTouched = 4;
inline constexpr std::size_t kDisplacement = 5; ///< of the touched place: ComparedResponse::displacement_m
inline constexpr std::size_t kDepth = 6;        ///< ComparedResponse::depth_m, 0 out of contact
inline constexpr std::size_t kVelocity = 7;     ///< x, y, z of the tool, m/s, as the laws use it
inline constexpr std::size_t kCount = 10;
} // namespace comparison_quantity

/// Objects side by side that are presented and answered one trial after the other (P2's studies). The trials
/// follow the course of TrialCourse, but are not planned: each begins when a word has been presented, and the
/// session ends after an `answer` of kAnswerFinish. kCompleted (answered), kTimedOut or kFailed (spoiled)
/// ends a trial. In idle, between and finished there are no objects and force is zero. The same holds between
/// the two limits of a trial, while the scene waits for an answer. With `freeFirst`, neither limit applies to
/// the first presentation of the session; only the runner ends it. A `present` that comes early waits until
/// it is due. With `adjusts`, a `present` in a running trial changes the objects; each place changes as soon
/// as it is not touched, so that nobody feels a step. Tool 0 explores. While paused the clocks stand still;
/// contact still produces forces.
///
/// Deterministic: values follow from the parameters and the presented word, micro-heights from session seed,
/// trial and place.
/// Thread: haptic for respond(); any for construction.
class ComparisonScene final : public IScene {
public:
    ComparisonScene(const ComparisonParameters& parameters, std::uint64_t seed);
    ~ComparisonScene() override;
    ComparisonScene(const ComparisonScene&) = delete;
    ComparisonScene& operator=(const ComparisonScene&) = delete;

    void respond(const realtime::HapticTick& now, const SceneInput& in, SceneOutput& out) noexcept override;

    /// The value of the attribute at a place for a presented word, SI, including the control's fault. Empty
    /// where the word or the place does not exist.
    std::optional<double> valueAt(const core::PresentationWord& word, int place) const noexcept;

private:
    void hear(const SceneInput& in) noexcept;
    void advance(const SceneInput& in, SceneOutput& out) noexcept;
    void prepare() noexcept;
    void run(SceneOutput& out) noexcept;
    void leave() noexcept;
    void setPlaces(bool onlyChanged) noexcept;
    bool known(const core::PresentationWord& word) const noexcept;
    bool freely() const noexcept;
    bool exploring() const noexcept;
    int buttonAnswer(const SceneInput& in) noexcept;
    bool countsAsTouched(const ComparedResponse& response) const noexcept;
    void touch(const SceneInput& in, SceneOutput& out) noexcept;
    ComparedResponse respondAll(const core::ToolState& tool, double mostDamping_Ns_per_m,
                                SceneOutput& out) noexcept;
    double boundOn(double force_N) const noexcept;
    void fillQuantities(const ComparedResponse& felt, const core::ToolState& tool,
                        SceneOutput& out) const noexcept;
    void fillCues(SceneOutput& out) const noexcept;

    ComparisonParameters m_parameters;
    std::uint64_t m_seed;
    std::uint64_t m_exploreTicks; ///< 0: no limit
    TrialCourse m_course;
    bool m_showsObjects;

    bool m_begun = false; ///< a trial was presented before
    bool m_finish = false;
    bool m_pending = false; ///< a word is waiting
    core::PresentationWord m_next;
    core::PresentationWord m_word; ///< the word that is presented
    bool m_answering = false;      ///< an answer has come
    std::uint16_t m_answerWord = 0;
    int m_answered = -1; ///< in this trial
    bool m_buttonWasDown = true;
    std::uint32_t m_touched = 0;
    int m_place = -1;
    double m_steepest = 1.0; ///< of the pads at hand (ComparedObject::steepest())
    bool m_touching = false;
    bool m_paused = false;
    std::array<ComparedObject, ComparisonParameters::kMaxPlaces> m_objects;
    /// The word that each place shows now.
    std::array<core::PresentationWord, ComparisonParameters::kMaxPlaces> m_set{};
};

} // namespace chiron::simulation
