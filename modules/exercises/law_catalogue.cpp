// SPDX-License-Identifier: GPL-3.0-or-later
// The laws that the command line tabulates, one per line, including those of single exercises.
#include "modules/exercises/sphere_apex/simulation/hemisphere_contact_law.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces_law.h"
#include "simulation/attributes/evaluate_attributes.h"
#include "simulation/attributes/evaluate_friction.h"
#include "simulation/evaluate_laws.h"
#include "simulation/geometry/mesh/evaluate_mesh.h"
#include "simulation/geometry/urethra/evaluate_urethra_geometry.h"
#include "simulation/palpation/evaluate_palpation.h"

#include <array>

namespace chiron::simulation {

namespace {

const std::array<core::LawDescription, 18> kLaws{{
    hemisphereLaw(),
    frictionLaw(),
    urethraCentrelineLaw(),
    urethraProfileLaw(),
    urethraSurfaceLaw(),
    urethraForceLaw(),
    elasticityLaw(),
    strainStiffeningLaw(),
    massLaw(),
    deformationLaw(),
    roughnessLaw(),
    bristleFrictionLaw(),
    viscosityLaw(),
    elasticTubeLaw(),
    meshContactLaw(),
    voigtLaw(),
    palpationContactLaw(),
    palpationLumpLaw(),
}};

} // namespace

std::span<const core::LawDescription> evaluateLaws() noexcept {
    return kLaws;
}

} // namespace chiron::simulation
