// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace chiron::core {

/// Quantities of a scene that are recorded beside the tools: what cannot be told from poses and wrenches alone (which end
/// is held, where a dropped object lies, how hard a jaw squeezes). A kind of exercise names its own, in order.
inline constexpr std::size_t kMaxQuantities = 20;

/// What one of `SceneOutput::quantities` means. The name carries the unit as the content's keys do, e.g. "squeeze_0_N".
struct QuantityDescription {
    std::string id;          ///< snake_case with its unit, unique within the kind
    std::string unit;        ///< SI: "N", "m", "1"
    double resolution = 0.0; ///< of the recording, in that unit; > 0
};

} // namespace chiron::core
