// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/observers/observer_spec.h"
#include "session/station.h"
#include "session/study/study_progress.h"
#include "session/study/study_store.h"

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>

namespace chiron::session {

/// One session of the sphere-apex exercise whose trials become a study's: a hidden sphere each, at another place, one mark each.
struct ApexSitting {
    const OpenedStudy& study;
    const psychophysics::Condition& condition;
    StudyProgress& progress;
    database::StudyRunNumber run = 0;
    std::string sealedCode;
    std::string trainee;    ///< scripted trainee of the exercise; empty: kUsualTrainee
    std::uint64_t seed = 1; ///< of the places, of hand and mind
    int trials = 1;         ///< presentations in this session
    std::filesystem::path ringFolder;
    const std::atomic<bool>* cancel = nullptr;
    std::function<bool(database::StudyTrial)> store; ///< false ends the session
};

/// Its technique is the plain one, neither the exercise's best nor its worst. It knows only what it feels.
inline constexpr const char* kUsualTrainee = "intermediate";

bool looksForApex(const psychophysics::Condition& condition) noexcept;

/// The exercise's level for a condition, by touch alone unless the design shows its objects. Failure: badInput.
core::Result<catalogue::ExerciseLevel> apexStudyLevel(const psychophysics::StudyDesign& design, const psychophysics::Condition& condition,
                                                      int trials, const std::string& sealedCode = {});
/// P2's simulated gimbal with the trainee's hand on it. Failure: notFound naming the trainees there are.
core::Result<Station> apexStation(const catalogue::ExerciseLevel& level, const std::string& trainee, std::uint64_t seed);

/// Runs it through scene, loop, supervisor and simulated device as fast as the machine can, recorded; each trial's error along x and y
/// is taken from the tick of the mark and goes with its fidelity, its distance is the trial's value. Ends early where the run is done,
/// given up, cancelled or cannot be stored. Failure: badInput, notFound, storage.
core::Result<database::SessionId> runApexSitting(database::Database& database, const database::Actor& actor, const ApexSitting& sitting);

/// A mark of the observer for planning (psychophysics::ApexObserver): nothing is rendered. `seed` and `ordinal` decide it.
StudyAnswer plannedApexAnswer(double radius_m, std::uint64_t seed, int ordinal);

} // namespace chiron::session
