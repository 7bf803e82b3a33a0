// SPDX-License-Identifier: GPL-3.0-or-later
// Construction and destruction of an organ. They allocate and free, and therefore stand apart from the tick.
#include "simulation/deformable/deformable_organ.h"

#include <string>
#include <utility>

namespace chiron::simulation {

core::Result<std::unique_ptr<DeformableOrgan>> DeformableOrgan::create(const TriangleMesh& mesh,
                                                                       const std::vector<bool>& anchored,
                                                                       std::uint32_t reference,
                                                                       const Settings& settings) {
    if (settings.blend_ticks == 0 || settings.blend_ticks > settings.timing.latency_ticks ||
        settings.timing.period_ticks == 0 || !(settings.prediction >= 0.0 && settings.prediction <= 1.0))
        return core::fail(core::ErrorCode::badInput,
                          "deformable organ: a blend of " + std::to_string(settings.blend_ticks) +
                              " ticks at a latency of " + std::to_string(settings.timing.latency_ticks) +
                              ", expected 1 to the latency, and a prediction of 0 to 1");
    std::vector<core::Vec3> vertices;
    for (const SurfaceVertex& vertex : mesh.vertices())
        vertices.push_back(vertex.position);
    std::vector<MeshTriangle> triangles;
    for (const SurfaceTriangle& triangle : mesh.triangles())
        triangles.push_back(triangle.vertex);
    auto network = SpringNetwork::create({vertices, triangles}, anchored, reference, settings.network);
    CHIRON_TRY(network);
    return std::unique_ptr<DeformableOrgan>(new DeformableOrgan(mesh, std::move(*network), settings));
}

DeformableOrgan::DeformableOrgan(const TriangleMesh& mesh, std::unique_ptr<SpringNetwork> network,
                                 const Settings& settings)
    : m_mesh(mesh), m_settings(settings), m_blend(settings.blend_ticks, settings.prediction),
      m_link(settings.timing), m_network(std::move(network)), m_angles(cornerAngles(mesh)),
      m_places(mesh.vertices().size()), m_normals(mesh.vertices().size()) {
    for (auto& slot : m_slots)
        slot.resize(mesh.vertices().size());
}

DeformableOrgan::~DeformableOrgan() = default;

} // namespace chiron::simulation
