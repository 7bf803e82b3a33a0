// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/mesh/make_mesh.h"

#include "core/units.h"

#include <cmath>
#include <string>

namespace chiron::simulation {

namespace {

core::Result<void> positive(const char* name, double value) {
    if (std::isfinite(value) && value > 0.0)
        return {};
    return core::fail(core::ErrorCode::badInput,
                      std::string("mesh: ") + name + ": " + std::to_string(value) + ", expected more than 0");
}

/// Estimates the number of triangles as the area divided by that of an equilateral triangle with the
/// requested edge.
double expectedTriangles(const MeshSource& s) {
    const double triangle = std::sqrt(3.0) / 4.0 * s.edge_m * s.edge_m;
    if (s.shape == MeshSource::Shape::dome) {
        const double r = s.halfAxisX_m, plate = s.plateRadius_m;
        return core::kPi * (r * r + 2.0 * plate * plate + 2.0 * plate * s.plateThickness_m) / triangle;
    }
    const double mean = (s.halfAxisX_m + s.halfAxisY_m + s.halfAxisZ_m) / 3.0;
    return 4.0 * core::kPi * mean * mean / triangle;
}

core::Result<void> checkGenerator(const MeshSource& s) {
    for (const auto& [name, value] : {std::pair{"halfAxisX_m", s.halfAxisX_m},
                                      {"halfAxisY_m", s.halfAxisY_m},
                                      {"halfAxisZ_m", s.halfAxisZ_m},
                                      {"edge_m", s.edge_m},
                                      {"bumpWavelength_m", s.bumpWavelength_m}})
        CHIRON_TRY(positive(name, value));
    if (!(s.bumpHeight_m >= 0.0) || s.bumpHeight_m * 2.0 * core::kPi > s.bumpWavelength_m)
        return core::fail(core::ErrorCode::badInput,
                          "mesh: bumpHeight_m: " + std::to_string(s.bumpHeight_m) +
                              ", expected 0 to bumpWavelength_m / 2π (a slope of 1)");
    if (s.shape == MeshSource::Shape::dome) {
        CHIRON_TRY(positive("plateThickness_m", s.plateThickness_m));
        if (!(s.plateRadius_m > s.halfAxisX_m + s.edge_m))
            return core::fail(core::ErrorCode::badInput,
                              "mesh: plateRadius_m: " + std::to_string(s.plateRadius_m) +
                                  ", expected more than the dome's radius and an edge");
    }
    if (expectedTriangles(s) > static_cast<double>(TriangleMesh::kMostTriangles))
        return core::fail(core::ErrorCode::badInput,
                          "mesh: edge_m: " + std::to_string(s.edge_m) + " makes more than " +
                              std::to_string(TriangleMesh::kMostTriangles) + " triangles");
    return {};
}

core::Result<MeshShape> storedShape(const MeshSource& s) {
    if (s.vertices_um.size() % 3 != 0 || s.triangles.size() % 3 != 0)
        return core::fail(core::ErrorCode::badInput,
                          "mesh: " + std::to_string(s.vertices_um.size()) + " coordinates and " +
                              std::to_string(s.triangles.size()) + " corners, expected three each");
    MeshShape shape;
    shape.vertices.reserve(s.vertices_um.size() / 3);
    for (std::size_t i = 0; i < s.vertices_um.size(); i += 3)
        shape.vertices.push_back(1e-6 *
                                 core::Vec3(s.vertices_um[i], s.vertices_um[i + 1], s.vertices_um[i + 2]));
    shape.triangles.reserve(s.triangles.size() / 3);
    for (std::size_t i = 0; i < s.triangles.size(); i += 3)
        shape.triangles.push_back({s.triangles[i], s.triangles[i + 1], s.triangles[i + 2]});
    return shape;
}

} // namespace

core::Result<MeshShape> makeMeshShape(const MeshSource& source) {
    switch (source.shape) {
    case MeshSource::Shape::stored:
        return storedShape(source);
    case MeshSource::Shape::dome:
    case MeshSource::Shape::ellipsoid:
        CHIRON_TRY(checkGenerator(source));
        return source.shape == MeshSource::Shape::dome ? domeShape(source) : ellipsoidShape(source);
    case MeshSource::Shape::none:
        break;
    }
    return core::fail(core::ErrorCode::badInput, "mesh: no shape, expected dome, ellipsoid or stored");
}

core::Result<TriangleMesh> makeMesh(const MeshSource& source) {
    const core::Result<MeshShape> shape = makeMeshShape(source);
    CHIRON_TRY(shape);
    return TriangleMesh::create(shape->vertices, shape->triangles);
}

} // namespace chiron::simulation
