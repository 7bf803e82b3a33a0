// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "simulation/yield.h"

#include <string>

namespace chiron::session {

/// When a level's tissue gives way, as its kind says (ExerciseKind::yieldLaw); of a kind that is not known, never.
simulation::YieldLaw yieldLawOf(const catalogue::ExerciseLevel& level);

/// Whether it was the torque that tissue gave way to: what the law answered at that tick, ‖f‖ in N and ‖τ‖ in N·m, is at the limit of one of
/// them and below that of the other (simulation::TissueYield). A law without a yield torque, as of sessions before there was one, gives way to
/// force alone. Pure.
bool gaveWayToTorque(const simulation::YieldLaw& law, double force_N, double torque_Nm) noexcept;

/// The same from a stored event "tissue_yielded".
struct YieldCause {
    bool byTorque = false;
    double value = 0.0; ///< the force in N, or the torque in mN·m
};
/// `detailJson`: as EventExtractor writes it.
YieldCause yieldCauseOf(const simulation::YieldLaw& law, const std::string& detailJson);

} // namespace chiron::session
