// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/api/device_descriptor.h"
#include "mechanisms/hand_strategy.h"
#include "modules/exercises/elastic_tube/operators/operator_settings.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace chiron::operators {

/// What is asked for, as the instruction on the screen says.
enum class TubeGoal {
    tension, ///< keep the tension in the band
    mark,    ///< stretch it to the mark, and keep it there
    bring,   ///< hand the end over and lead it to its target
};

/// What a trainee is told before it begins: nothing that the screen and the instruments in its hands do not say.
struct ElasticTubeBriefing {
    TubeGoal goal = TubeGoal::tension;
    double markRatio = 1.0;     ///< mark: as length over rest length; used where the screen does not show it …
    double markTolerance = 0.04; ///< … and how near to it counts, either way
    bool retracts = false; ///< the last instrument holds back a fold that lies over the tube
    std::vector<devices::WorkspaceMapping> places{devices::WorkspaceMapping{}}; ///< one an instrument: where it enters
};

/// The scripted laparoscopists of the elastic tube: novice, intermediate, expert, unsafe. Static data; any thread.
std::span<const std::string_view> elasticTubeOperatorNames() noexcept;

/// The settings a name stands for. Fails (notFound) for an unknown name, listing the known ones.
core::Result<ElasticTubeOperatorSettings> elasticTubeOperatorSettings(std::string_view name);

/// One mind and a hand a tool, in the tools' order, each for a SimulatedDevice at its place. Seeded: the same seed and the same
/// perceptions give the same intentions. Fails (badInput) when a setting is out of its range or there is not a place for one to three
/// instruments. Allocates; not in the tick.
core::Result<std::vector<std::unique_ptr<mechanisms::HandStrategy>>>
makeElasticTubeOperator(const ElasticTubeOperatorSettings& settings, const ElasticTubeBriefing& briefing, std::uint64_t seed);

} // namespace chiron::operators
