// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/objects/object_contact.h"

namespace chiron::simulation {

ObjectContact::ObjectContact(const ObjectAttributes& a) noexcept
    : m_surface{elasticOf(a), a.recoveryShare * a.stiffness_N_per_m, a.recoveryTime_s},
      m_roughness(a.roughness_m, a.roughnessWavelength_m, a.roughnessSeed), m_friction(a.friction),
      m_bristleStiffness_N_per_m(a.bristleStiffness_N_per_m), m_viscosity_Ns_per_m(a.viscosity_Ns_per_m),
      m_damping_Ns_per_m(a.damping_Ns_per_m), m_mass_kg(a.mass_kg) {}

} // namespace chiron::simulation
