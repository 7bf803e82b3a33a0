// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep/true_contact.h"

#include "sweep/triangle_distance.h"

#include <cmath>
#include <vector>

namespace chiron::tests {

bool objectsPresent(const simulation::SceneOutput& out) {
    return out.phase == core::TrialPhase::ready || out.phase == core::TrialPhase::running;
}

double roughRise_m(double rms_m) {
    return rms_m * std::sqrt(2.0 * 64.0);
}

const simulation::DeformableOrgan* organOf(simulation::IScene& scene) {
    return dynamic_cast<const simulation::DeformableOrgan*>(scene.slowModel());
}

double distanceFrom_m(const simulation::DeformableOrgan& organ, const core::Vec3& p) {
    const simulation::TriangleMesh& rest = organ.restMesh();
    std::vector<core::Vec3> places; // once each: they are blended anew whenever they are asked for
    places.reserve(rest.vertices().size());
    for (std::uint32_t vertex = 0; vertex < rest.vertices().size(); ++vertex)
        places.push_back(organ.position(vertex));
    return signedDistance_m(
        rest.triangles(), [&places](std::uint32_t vertex) -> const core::Vec3& { return places[vertex]; }, p,
        rest.longestEdge_m() + 2.0 * organ.largestDisplacement_m());
}

} // namespace chiron::tests
