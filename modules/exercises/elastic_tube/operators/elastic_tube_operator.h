// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "devices/api/device_descriptor.h"
#include "mechanisms/hand_strategy.h"
#include "modules/exercises/elastic_tube/operators/elastic_tube_operator_settings.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace chiron::operators {

/// The goal of the task, as the instruction on the screen states it.
enum class TubeGoal {
    tension, ///< keep the tension in the band
    mark,    ///< stretch it to the mark, and keep it there
    bring,   ///< hand the end over and lead it to its target
};

/// Instructions to a trainee before it begins. They contain nothing beyond what the screen and the
/// instruments in its hands say.
struct ElasticTubeBriefing {
    TubeGoal goal = TubeGoal::tension;
    /// mark: length over rest length; used where the screen does not show the mark …
    double markRatio = 1.0;
    double markTolerance = 0.04; ///< … and the distance to it that still counts, in either direction
    bool retracts = false;       ///< the last instrument holds back a fold that lies over the tube
    /// One per instrument: where it enters.
    std::vector<devices::WorkspaceMapping> places{devices::WorkspaceMapping{}};
};

/// The names of the scripted laparoscopists of the elastic tube: novice, intermediate, expert, unsafe. Static
/// data.
/// Thread: any.
std::span<const std::string_view> elasticTubeOperatorNames() noexcept;

/// Returns the settings of the laparoscopist with this name.
/// Errors: notFound for an unknown name, listing the known ones.
core::Result<ElasticTubeOperatorSettings> elasticTubeOperatorSettings(std::string_view name);

/// Makes one strategy with one hand per tool, in the order of the tools, each for a SimulatedDevice at its
/// place. It is seeded: the same seed and the same perceptions give the same intentions. Allocates; not for
/// use in the tick.
/// Errors: badInput when a setting is out of range or when the places are not those of one to three
/// instruments.
core::Result<std::vector<std::unique_ptr<mechanisms::HandStrategy>>>
makeElasticTubeOperator(const ElasticTubeOperatorSettings& settings, const ElasticTubeBriefing& briefing,
                        std::uint64_t seed);

} // namespace chiron::operators
