// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/study_setup.h"

#include "curriculum/exercises/comparison/catalogue/comparison_content.h"
#include "core/random.h"
#include "devices/drivers/simulated/simulated_device.h"
#include "modules/exercises/comparison/operators/comparison_explorer.h"

#include <algorithm>

namespace chiron::session {

core::Result<catalogue::ExerciseLevel> studyLevel(const psychophysics::StudyDesign& design, const psychophysics::Condition& condition,
                                                  simulation::ComparisonControl control, const std::string& sealedCode) {
    auto parameters = catalogue::comparisonOf(condition, design.trial);
    if (!parameters)
        return tl::unexpected(parameters.error());
    parameters->control = control;
    return catalogue::comparisonLevel(*parameters, design.id, sealedCode.empty() ? condition.id : sealedCode);
}

const psychophysics::Condition* conditionOf(const psychophysics::StudyDesign& design, const std::string& id) {
    const auto found = std::find_if(design.conditions.begin(), design.conditions.end(), [&](const auto& c) { return c.id == id; });
    return found == design.conditions.end() ? nullptr : &*found;
}

core::Result<ParticipantStation> participantStation(const catalogue::ExerciseLevel& level, std::uint64_t seed) {
    const auto& parameters = level.parameters.as<simulation::ComparisonParameters>();
    auto explorer = operators::makeComparisonExplorer(operators::comparisonBriefing(parameters));
    if (!explorer)
        return tl::unexpected(explorer.error());
    ParticipantStation out;
    out.mind = explorer->get();
    devices::SimulatedDevice::Configuration configuration;
    configuration.hand = operators::comparisonHand();
    configuration.seed = core::Random::mix(seed, "hand");
    auto device = devices::SimulatedDevice::create(configuration, std::move(*explorer));
    if (!device)
        return tl::unexpected(device.error());
    out.station.operatorName = "participant";
    out.station.tools.push_back({std::move(*device), configuration.mapping, {}});
    return out;
}

} // namespace chiron::session
