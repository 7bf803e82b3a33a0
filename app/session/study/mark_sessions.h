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

/// One session of an exercise whose trials become a study's: something is looked for in each, and marked once.
struct MarkSitting {
    const OpenedStudy& study;
    const psychophysics::Condition& condition;
    StudyProgress& progress;
    database::StudyRunNumber run = 0;
    std::string sealedCode;
    std::string trainee;    ///< scripted trainee of the exercise; empty: the usual one
    std::uint64_t seed = 1; ///< of what is looked for, of hand and mind
    int trials = 1;         ///< presentations in this session
    std::filesystem::path ringFolder;
    const std::atomic<bool>* cancel = nullptr;
    std::function<bool(database::StudyTrial)> store; ///< false ends the session
};

/// How an exercise serves studies whose answers are marks: with sessions of its own scene. Without state; any thread.
class MarkSessions {
public:
    virtual ~MarkSessions() = default;

    virtual int trialsAtMost() const noexcept = 0; ///< in one session
    /// The exercise's level for a condition, which sessions call by `label` (empty: the condition's id); by touch alone unless the design
    /// shows its objects. Failure: badInput.
    virtual core::Result<catalogue::ExerciseLevel> level(const psychophysics::StudyDesign& design, const psychophysics::Condition& condition,
                                                         int trials, const std::string& label) const = 0;
    /// A simulated device with a scripted trainee's hand on it. Failure: notFound naming the trainees there are.
    virtual core::Result<Station> scripted(const catalogue::ExerciseLevel& level, const std::string& trainee, std::uint64_t seed) const = 0;
    /// Runs a sitting through scene, loop, supervisor and simulated device as fast as the machine can, recorded. Ends early where the run
    /// is done, given up, cancelled or cannot be stored. Failure: badInput, notFound, storage.
    virtual core::Result<database::SessionId> run(database::Database& database, const database::Actor& actor, const MarkSitting& sitting) const = 0;
    /// A person's sitting, in a window. Failure: as LiveSitting::start.
    virtual SittingResult<std::unique_ptr<LiveSitting>> begin(database::Database& database, const database::Actor& actor,
                                                              const ConductedSitting& sitting, LiveStudyRequest request) const = 0;
};

/// Of the exercise that serves the condition (ExerciseKind::markSessions); null where it asks for no mark: its objects are compared.
const MarkSessions* markSessionsOf(const psychophysics::Condition& condition);

/// Whether the answer is a mark at the apex.
bool looksForApex(const psychophysics::Condition& condition) noexcept;
/// A mark of the observer for planning (psychophysics::ApexObserver): nothing is rendered. `seed` and `ordinal` decide it.
StudyAnswer plannedMark(double radius_m, std::uint64_t seed, int ordinal);

} // namespace chiron::session
