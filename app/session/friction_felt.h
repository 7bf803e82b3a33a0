// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "mechanisms/gimbal_plant_parameters.h"

#include <string>
#include <vector>

namespace chiron::session {

/// What a hand feels of the gimbal's own friction at one speed, with nothing touched.
struct FrictionFeltRow {
    std::string direction;      ///< sideways (heading) or along (depth)
    double speed_m_per_s = 0.0; ///< of the tip
    double before_N = 0.0;      ///< mean force against the motion at constant speed, there and back
    double after_N = 0.0;       ///< the same with the compensation
};

struct FrictionFelt {
    double compensation = 0.0; ///< share of the identified Coulomb friction
    std::vector<FrictionFeltRow> rows;
    double heldBefore_N = 0.0, heldAfter_N = 0.0; ///< largest change that a still hand feels in 2 s: 0 where nothing moves by itself
    double workBefore_J = 0.0, workAfter_J = 0.0; ///< that the hand does in all closed strokes: above 0, nothing is made
};

/// The gimbal (P2) held by a hand that moves it to and fro at 1 to 150 mm/s through loop and supervisor, nothing touched; without and with
/// its friction fed forward (haptics/friction_compensation.h). The force is what the plant truly puts on the hand. About 80 s of device
/// time twice, as fast as the machine can. Deterministic. Failure: badInput for a share beyond 0..1; what making the device says.
core::Result<FrictionFelt> feelFriction(const mechanisms::GimbalPlantParameters& plant, double compensation);

} // namespace chiron::session
