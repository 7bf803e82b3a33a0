// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "mechanisms/gimbal_plant_parameters.h"

#include <string>
#include <vector>

namespace chiron::session {

/// The friction of the gimbal that a hand feels at one speed when nothing is touched.
struct FrictionFeltRow {
    std::string direction;      ///< sideways (heading) or along (depth)
    double speed_m_per_s = 0.0; ///< of the tip
    double before_N = 0.0;      ///< mean force against the motion at constant speed, in both directions
    double after_N = 0.0;       ///< the same with the compensation
};

struct FrictionFelt {
    double compensation = 0.0; ///< fraction of the identified Coulomb friction
    std::vector<FrictionFeltRow> rows;
    double heldBefore_N = 0.0, heldAfter_N = 0.0; ///< largest change that a still hand feels in 2 s: 0 if
                                                  ///< nothing moves by itself
    double workBefore_J = 0.0, workAfter_J = 0.0; ///< work of the hand in all closed strokes; positive: no
                                                  ///< energy is generated

    /// False if the compensation takes too little of the friction that a moving hand feels, pushes the hand
    /// by itself or generates energy. `rows`: of each direction by rising speed.
    bool holds() const;
};

/// Measures the friction of the gimbal (P2) while a simulated hand moves it to and fro at 1 to 150 mm/s
/// through loop and supervisor, with nothing touched; once without and once with feed-forward compensation of
/// its friction (haptics/friction_compensation.h). The force is the plant's true force on the hand. Simulates
/// about 80 s of device time twice, faster than real time. Deterministic.
/// Errors: badInput for a fraction outside 0..1; those of making the device.
core::Result<FrictionFelt> feelFriction(const mechanisms::GimbalPlantParameters& plant, double compensation);

} // namespace chiron::session
