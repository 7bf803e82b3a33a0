// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/study/mark_sessions.h"

namespace chiron::session {

/// Sessions of "sphere_apex" for the study of the apex: in each trial a hidden sphere at another position,
/// and one mark. A scripted trainee holds P2's simulated gimbal. The error along x and y at the tick of the
/// mark is stored with the trial's fidelity; the distance is the value of the trial.
class ApexSessions final : public MarkSessions {
public:
    /// The usual trainee has the plain technique, neither the best nor the worst of the exercise. It knows
    /// only what it feels.
    static constexpr const char* kUsualTrainee = "intermediate";

    int trialsAtMost() const noexcept override;
    core::Result<catalogue::ExerciseLevel> level(const psychophysics::StudyDesign& design,
                                                 const psychophysics::Condition& condition, int trials,
                                                 const std::string& label) const override;
    core::Result<Station> scripted(const catalogue::ExerciseLevel& level, const std::string& trainee,
                                   std::uint64_t seed) const override;
    core::Result<database::SessionId> run(database::Database& database, const database::Actor& actor,
                                          const MarkSitting& sitting) const override;
    SittingResult<std::unique_ptr<LiveSitting>> begin(database::Database& database,
                                                      const database::Actor& actor,
                                                      const ConductedSitting& sitting,
                                                      LiveStudyRequest request) const override;
};

} // namespace chiron::session
