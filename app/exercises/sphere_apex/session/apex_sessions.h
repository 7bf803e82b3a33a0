// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/study/mark_sessions.h"

namespace chiron::session {

/// The study of the apex: sessions of "sphere_apex", a hidden sphere a trial at another place each, one mark each. A scripted trainee holds
/// P2's simulated gimbal. Of a trial the error along x and y at the tick of the mark goes with its fidelity; their distance is its value.
class ApexSessions final : public MarkSessions {
public:
    /// Its technique is the plain one, neither the exercise's best nor its worst. It knows only what it feels.
    static constexpr const char* kUsualTrainee = "intermediate";

    int trialsAtMost() const noexcept override;
    core::Result<catalogue::ExerciseLevel> level(const psychophysics::StudyDesign& design, const psychophysics::Condition& condition, int trials,
                                                 const std::string& label) const override;
    core::Result<Station> scripted(const catalogue::ExerciseLevel& level, const std::string& trainee, std::uint64_t seed) const override;
    core::Result<database::SessionId> run(database::Database& database, const database::Actor& actor, const MarkSitting& sitting) const override;
    SittingResult<std::unique_ptr<LiveSitting>> begin(database::Database& database, const database::Actor& actor, const ConductedSitting& sitting,
                                                      LiveStudyRequest request) const override;
};

} // namespace chiron::session
