// SPDX-License-Identifier: GPL-3.0-or-later
// Called in the tick in which the next object appears, and therefore kept apart from the plan, which
// allocates.
#include "modules/exercises/sphere_apex/simulation/sphere_apex_plan.h"

namespace chiron::simulation {

HemisphereContact::Parameters sphereApexContact(const SphereApexParameters& parameters,
                                                const SphereApexTrial& trial) noexcept {
    HemisphereContact::Parameters contact;
    contact.surface = {parameters.radius_m, parameters.planeHeight_m, trial.centre_m};
    contact.stiffness = {trial.stiffness_N_per_m, parameters.stiffnessVariation,
                         parameters.stiffnessWavelength_m, trial.phase_rad};
    contact.dimple = {parameters.dimpleDepth_m, parameters.dimpleRadius_m, trial.dimpleCentre_m};
    contact.damping_Ns_per_m = parameters.damping_Ns_per_m;
    contact.friction = trial.friction;
    contact.bristleStiffness_N_per_m = parameters.bristleStiffness_N_per_m;
    return contact;
}

} // namespace chiron::simulation
