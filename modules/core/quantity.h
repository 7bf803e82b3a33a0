// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace chiron::core {

/// Largest number of quantities of a scene that are recorded in addition to the tools: values that cannot be
/// derived from poses and wrenches alone (which end is held, where a dropped object lies, how hard a jaw
/// squeezes). Each type of exercise names its own, in order.
inline constexpr std::size_t kMaxQuantities = 20;

/// Describes one of `SceneOutput::quantities`. The name carries the unit, as content keys do, e.g.
/// "squeeze_0_N".
struct QuantityDescription {
    std::string id;          ///< snake_case with its unit, unique within the exercise type
    std::string unit;        ///< SI: "N", "m", "1"
    double resolution = 0.0; ///< resolution of the recording, in that unit; > 0
};

} // namespace chiron::core
