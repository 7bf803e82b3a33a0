// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/object_handling/scene/organ_bed.h"

#include "cues/laparoscopy_cues.h"
#include "desktop/scene3d/drawn_tool.h"
#include "simulation/geometry/mesh/make_mesh.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

/// Adds a dent under an object with this lowest point; does nothing if the point is above the organ.
void addDent(std::vector<Dent>& dents, const simulation::ObjectHandlingParameters& parameters,
             const core::Vec3& lowest, double wide_m) {
    const double height_m = organHeight_m(parameters, lowest.x(), lowest.y());
    if (!lowest.allFinite() || lowest.z() >= height_m)
        return;
    Dent dent;
    dent.p_WSurface = {lowest.x(), lowest.y(), height_m};
    dent.depth_m = height_m - lowest.z();
    dent.reach_m = wide_m + Dent::kReachPerDepth * dent.depth_m;
    dents.push_back(dent);
}

} // namespace

TriangleMesh organMesh(const simulation::ObjectHandlingParameters& parameters) {
    TriangleMesh mesh;
    const auto shape = simulation::makeMeshShape(parameters.bedMesh);
    if (!shape || shape->vertices.empty())
        return mesh;
    double highest_m = shape->vertices.front().z();
    for (const core::Vec3& p : shape->vertices)
        highest_m = std::max(highest_m, p.z());
    std::vector<core::Vec3> normals(shape->vertices.size(), core::Vec3::Zero());
    for (const auto& t : shape->triangles) {
        const core::Vec3 across = (shape->vertices[t[1]] - shape->vertices[t[0]])
                                      .cross(shape->vertices[t[2]] - shape->vertices[t[0]]);
        for (const std::uint32_t i : t) {
            normals[i] += across;
            mesh.indices.push_back(i);
        }
    }
    for (std::size_t i = 0; i < shape->vertices.size(); ++i) {
        const core::Vec3 p_mm = 1e3 * (shape->vertices[i] - core::Vec3(0.0, 0.0, highest_m));
        const core::Vec3 n =
            normals[i].norm() > 0.0 ? core::Vec3(normals[i].normalized()) : core::Vec3(core::Vec3::UnitZ());
        MeshVertex v;
        for (int k = 0; k < 3; ++k) {
            v.position_mm[k] = static_cast<float>(p_mm[k]);
            v.normal[k] = static_cast<float>(n[k]);
        }
        v.texture[0] = v.position_mm[0];
        v.texture[1] = v.position_mm[1];
        mesh.vertices.push_back(v);
    }
    return mesh;
}

double organHeight_m(const simulation::ObjectHandlingParameters& parameters, double x_m, double y_m) {
    if (!parameters.organBed)
        return 0.0;
    const simulation::MeshSource& mesh = parameters.bedMesh;
    const double x = x_m / std::max(1e-3, mesh.halfAxisX_m);
    const double y = y_m / std::max(1e-3, mesh.halfAxisY_m);
    return mesh.halfAxisZ_m * (std::sqrt(std::max(0.0, 1.0 - x * x - y * y)) - 1.0);
}

std::vector<Dent> organDents(const simulation::ObjectHandlingParameters& parameters,
                             const SceneState& state) {
    std::vector<Dent> dents;
    for (const ToolView& tool : state.tool)
        if (tool.present)
            addDent(dents, parameters, drawnTip(tool), Dent::kBaseReach_m);
    const core::LaparoscopyCues& cues = state.exercise.of<core::LaparoscopyCues>();
    for (int i = 0; i < cues.bodies && cues.objectShown; ++i) {
        const core::BodyCue& body = cues.body[static_cast<std::size_t>(i)];
        addDent(dents, parameters, {body.p_W[0], body.p_W[1], body.p_W[2] - body.radius_m},
                1.4 * body.radius_m);
    }
    return dents;
}

TriangleMesh dented(TriangleMesh mesh, const std::vector<Dent>& dents) {
    for (MeshVertex& v : mesh.vertices) {
        core::Vec3 p_W(1e-3 * double(v.position_mm[0]), 1e-3 * double(v.position_mm[1]),
                       1e-3 * double(v.position_mm[2]));
        for (const Dent& dent : dents)
            p_W = dent.displaced(p_W);
        for (int k = 0; k < 3; ++k)
            v.position_mm[k] = static_cast<float>(p_W[k] * 1e3);
    }
    return mesh;
}

} // namespace chiron::scene3d
