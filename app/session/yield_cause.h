// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "core/geometry.h"
#include "core/haptic_frame.h"
#include "recording/position_of.h"
#include "simulation/yield.h"

#include <optional>
#include <string>

namespace chiron::session {

/// The law by which a level's tissue gives way, as defined by its exercise (ExerciseKind::yieldLaw); never
/// for an unknown exercise.
simulation::YieldLaw yieldLawOf(const catalogue::ExerciseLevel& level);

/// True if the tissue gave way to the torque: at that tick, ‖f‖ in N and ‖τ‖ in N·m of the law's response,
/// one is at its limit and the other below its own (simulation::TissueYield). A law without a yield torque,
/// as in sessions before it existed, gives way to force alone. Pure function.
bool gaveWayToTorque(const simulation::YieldLaw& law, double force_N, double torque_Nm) noexcept;

/// The same from a stored event "tissue_yielded".
struct YieldCause {
    bool byTorque = false;
    double value = 0.0; ///< the force in N, or the torque in mN·m
};
/// `detailJson`: in the format that EventExtractor writes.
YieldCause yieldCauseOf(const simulation::YieldLaw& law, const std::string& detailJson);

/// Where tissue gave way: the tip of the tool in the frame of that tick, m, W. No value without `positions`,
/// or if the packet was refused, whose counts cannot be trusted. Pure function.
std::optional<core::Vec3> yieldPlaceOf(const recording::IPositionOf* positions, int tool,
                                       const core::ToolFrame& frame) noexcept;

} // namespace chiron::session
