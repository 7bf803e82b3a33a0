// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/mesh/evaluate_mesh.h"

#include "simulation/geometry/mesh/make_mesh.h"
#include "simulation/geometry/mesh/mesh_contact.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace chiron::simulation {

namespace {

using core::LawColumn;
using core::LawParameter;

constexpr std::array<LawColumn, 6> kInputs{{{"px_m", "m"},
                                            {"py_m", "m"},
                                            {"pz_m", "m"},
                                            {"vx_m_per_s", "m/s"},
                                            {"vy_m_per_s", "m/s"},
                                            {"vz_m_per_s", "m/s"}}};
constexpr std::array<LawColumn, 8> kOutputs{{{"fx_N", "N"},
                                             {"fy_N", "N"},
                                             {"fz_N", "N"},
                                             {"depth_m", "m"},
                                             {"nx", "1"},
                                             {"ny", "1"},
                                             {"nz", "1"},
                                             {"energy_J", "J"}}};

/// The first kOfMesh parameters describe the mesh; `dome` 1 makes a dome of half_axis_x_m on a plate, 0 an
/// ellipsoid.
constexpr std::size_t kOfMesh = 10;
constexpr std::array<LawParameter, 14> kParameters{{
    {"dome", "1", 0.0, 0.0, 1.0, true},
    {"half_axis_x_m", "m", 0.040, 0.001, 0.2},
    {"half_axis_y_m", "m", 0.030, 0.001, 0.2},
    {"half_axis_z_m", "m", 0.025, 0.001, 0.2},
    {"edge_m", "m", 0.0015, 0.0001, 0.05},
    {"bump_height_m", "m", 0.0, 0.0, 0.01},
    {"bump_wavelength_m", "m", 0.008, 0.0005, 0.2},
    {"bump_seed", "1", 1.0, 0.0, 4294967295.0, true},
    {"plate_radius_m", "m", 0.075, 0.001, 0.5},
    {"plate_thickness_m", "m", 0.010, 0.0001, 0.1},
    {"tool_radius_m", "m", 0.001, 0.0, 0.02},
    {"stiffness_N_per_m", "N/m", 500.0, 0.0, 10000.0},
    {"stiffening_per_m", "1/m", 0.0, 0.0, 1000.0},
    {"damping_Ns_per_m", "N·s/m", 1.0, 0.0, 100.0},
}};

MeshSource sourceFrom(std::span<const double> p) {
    MeshSource source;
    source.shape = p[0] >= 0.5 ? MeshSource::Shape::dome : MeshSource::Shape::ellipsoid;
    source.halfAxisX_m = p[1];
    source.halfAxisY_m = p[2];
    source.halfAxisZ_m = p[3];
    source.edge_m = p[4];
    source.bumpHeight_m = p[5];
    source.bumpWavelength_m = p[6];
    source.seed = static_cast<std::uint64_t>(p[7]);
    source.plateRadius_m = p[8];
    source.plateThickness_m = p[9];
    return source;
}

struct Kept {
    std::array<double, kOfMesh> parameters{};
    std::optional<TriangleMesh> mesh;
    bool known = false;
};

const std::optional<TriangleMesh>& meshFor(std::span<const double> p) {
    thread_local Kept kept; // a table has one mesh and many rows
    if (!kept.known || !std::equal(kept.parameters.begin(), kept.parameters.end(), p.begin())) {
        std::copy_n(p.begin(), kOfMesh, kept.parameters.begin());
        kept.known = true;
        auto mesh = makeMesh(sourceFrom(p));
        kept.mesh = mesh ? std::optional<TriangleMesh>(std::move(*mesh)) : std::nullopt;
    }
    return kept.mesh;
}

std::string meshProblem(std::span<const double> p, std::span<const double> in) {
    if (!in.empty() || meshFor(p))
        return {};
    const auto mesh = makeMesh(sourceFrom(p));
    return mesh ? std::string() : "the mesh: " + mesh.error().message;
}

void evaluateMeshContact(std::span<const double> p, std::span<const double> in,
                         std::span<double> out) noexcept {
    const std::optional<TriangleMesh>& mesh = meshFor(p);
    if (!mesh) {
        std::fill(out.begin(), out.end(), std::numeric_limits<double>::quiet_NaN());
        return;
    }
    ObjectAttributes attributes;
    attributes.stiffness_N_per_m = p[11];
    attributes.stiffening_per_m = p[12];
    attributes.damping_Ns_per_m = p[13];
    MeshContactState state;
    const MeshResponse response =
        MeshContact(attributes, p[10])
            .respond(*mesh, core::Vec3(in[0], in[1], in[2]), core::Vec3(in[3], in[4], in[5]), 0, state);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        out[axis] = response.contact.force[static_cast<Eigen::Index>(axis)];
        out[4 + axis] = response.contact.normal[static_cast<Eigen::Index>(axis)];
    }
    out[3] = response.contact.depth_m;
    out[7] = response.contact.energy_J;
}

} // namespace

core::LawDescription meshContactLaw() noexcept {
    return {"mesh-contact",
            "spherical tool tip on a triangle mesh with blended normals (not conservative)",
            "P2 \"Deformation\", figure 6; models.md §2.2",
            kInputs,
            kOutputs,
            kParameters,
            &evaluateMeshContact,
            &meshProblem};
}

} // namespace chiron::simulation
