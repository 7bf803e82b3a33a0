// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/study_setup.h"

#include "catalogue/comparison_content.h"
#include "core/random.h"
#include "operators/comparison/comparison_explorer.h"
#include "session/exercise_kind.h"

#include <algorithm>

namespace chiron::session {

core::Result<catalogue::ExerciseLevel> studyLevel(const psychophysics::StudyDesign& design,
                                                  const psychophysics::Condition& condition,
                                                  simulation::ComparisonControl control,
                                                  const std::string& sealedCode, bool freeFirst) {
    auto parameters = catalogue::comparisonOf(condition, design.trial);
    CHIRON_TRY(parameters);
    parameters->control = control;
    parameters->freeFirst = freeFirst;
    return catalogue::comparisonLevel(*parameters, design.id, sealedCode.empty() ? condition.id : sealedCode);
}

const psychophysics::Condition* conditionOf(const psychophysics::StudyDesign& design, const std::string& id) {
    const auto found = std::find_if(design.conditions.begin(), design.conditions.end(),
                                    [&](const auto& c) { return c.id == id; });
    return found == design.conditions.end() ? nullptr : &*found;
}

core::Result<ParticipantStation> participantStation(const catalogue::ExerciseLevel& level,
                                                    std::uint64_t seed) {
    const auto& parameters = level.parameters.as<simulation::ComparisonParameters>();
    auto explorer = operators::makeComparisonExplorer(operators::comparisonBriefing(parameters));
    CHIRON_TRY(explorer);
    ParticipantStation out;
    out.mind = explorer->get();
    SimulatedHand participant;
    participant.strategy = std::move(*explorer);
    participant.hand = operators::comparisonHand();
    participant.seed = core::Random::mix(seed, "hand");
    auto station = simulatedStation(kUsualMechanism, std::move(participant));
    CHIRON_TRY(station);
    out.station = std::move(*station);
    out.station.operatorName = "participant";
    return out;
}

} // namespace chiron::session
