// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace chiron::simulation {

/// The origin of a mesh, as a value that content holds and a session stores completely: one of the program's
/// own generators with its parameters, or triangles that were imported and checked. The same value gives the
/// same mesh, vertex for vertex. All units are SI unless a name says otherwise.
struct MeshSource {
    enum class Shape : std::uint8_t {
        none,
        dome,      ///< a watertight half ball on a plate: radius, bumps
        ellipsoid, ///< a closed organ: three half axes, bumps
        stored,    ///< `vertices_um` and `triangles`
    };
    Shape shape = Shape::none;
    std::string id;             ///< of the mesh in the content, shown to people
    double halfAxisX_m = 0.020; ///< dome: its radius
    double halfAxisY_m = 0.020;
    double halfAxisZ_m = 0.020;
    double plateRadius_m = 0.075; ///< dome: radius of the plate around it
    double plateThickness_m = 0.010;
    double edge_m = 0.0015;    ///< requested mean edge length
    double bumpHeight_m = 0.0; ///< amplitude of smooth bumps on the surface
    double bumpWavelength_m = 0.008;
    std::uint64_t seed = 1;                ///< of the bumps
    std::vector<std::int32_t> vertices_um; ///< stored: x, y, z in turn, µm
    std::vector<std::uint32_t> triangles;  ///< stored: three per triangle, counter-clockwise from outside
};

} // namespace chiron::simulation
