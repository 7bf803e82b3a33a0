// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/mesh/mesh_dents.h"

namespace chiron::simulation {

MeshDents::MeshDents(std::size_t vertices, double recoveryTime_s) : m_recoveryTime_s(recoveryTime_s) {
    if (recoveryTime_s > 0.0)
        m_dents.resize(vertices);
}

} // namespace chiron::simulation
