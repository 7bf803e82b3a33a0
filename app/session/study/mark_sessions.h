// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/station.h"
#include "session/study/live_sitting.h"
#include "session/study/study_progress.h"
#include "session/study/study_store.h"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace chiron::session {

struct ConductedSitting;

/// One session of an exercise whose trials become trials of a study. In each trial the participant looks for
/// something and marks it once.
struct MarkSitting {
    const OpenedStudy& study;
    const psychophysics::Condition& condition;
    StudyProgress& progress;
    database::StudyRunNumber run = 0;
    std::string sealedCode;
    std::string trainee;    ///< scripted trainee of the exercise; empty: the usual one
    std::uint64_t seed = 1; ///< of the targets, the hand and the operator's decision model
    int trials = 1;         ///< presentations in this session
    std::filesystem::path ringFolder;
    const std::atomic<bool>* cancel = nullptr;
    std::function<bool(database::StudyTrial)> store; ///< false ends the session
};

/// The support of an exercise for studies whose answers are marks, with sessions of its own scene. Stateless.
/// Thread: any.
class MarkSessions {
public:
    virtual ~MarkSessions() = default;

    virtual int trialsAtMost() const noexcept = 0; ///< in one session
    /// The exercise's level for a condition, which sessions call by `label` (empty: the condition's id). Its
    /// objects can only be felt unless the design shows them.
    /// Errors: badInput.
    virtual core::Result<catalogue::ExerciseLevel> level(const psychophysics::StudyDesign& design,
                                                         const psychophysics::Condition& condition,
                                                         int trials, const std::string& label) const = 0;
    /// A simulated device held by a scripted trainee.
    /// Errors: notFound naming the trainees that exist.
    virtual core::Result<Station> scripted(const catalogue::ExerciseLevel& level, const std::string& trainee,
                                           std::uint64_t seed) const = 0;
    /// Runs and records a session through scene, loop, supervisor and simulated device, faster than real
    /// time. Ends early if the run is done, given up, cancelled or cannot be stored.
    /// Errors: badInput, notFound, storage.
    virtual core::Result<database::SessionId> run(database::Database& database, const database::Actor& actor,
                                                  const MarkSitting& sitting) const = 0;
    /// Begins a person's run in a window.
    /// Errors: those of LiveSitting::start.
    virtual SittingResult<std::unique_ptr<LiveSitting>> begin(database::Database& database,
                                                              const database::Actor& actor,
                                                              const ConductedSitting& sitting,
                                                              LiveStudyRequest request) const = 0;
};

/// The support of the exercise that serves the condition (ExerciseKind::markSessions); null if the condition
/// asks for no mark because its objects are compared.
const MarkSessions* markSessionsOf(const psychophysics::Condition& condition);

/// True if the answer is a mark at the apex.
bool looksForApex(const psychophysics::Condition& condition) noexcept;
/// A mark of the observer model for planning (psychophysics::ApexObserver): nothing is rendered. Determined
/// by `seed` and `ordinal`.
StudyAnswer plannedMark(double radius_m, std::uint64_t seed, int ordinal);

} // namespace chiron::session
