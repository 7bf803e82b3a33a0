// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/sphere_apex/scene/apex_surface.h"

#include "cues/laparoscopy_cues.h"
#include "modules/exercises/sphere_apex/simulation/hemisphere_contact.h"
#include "modules/exercises/sphere_apex/simulation/touched_dome.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {
constexpr double kMargin_m = 0.013; // tissue visible round the workspace, and a little under the drape
}

ApexSurface ApexSurface::of(const simulation::SphereApexParameters& parameters, const SceneState& state) {
    ApexSurface surface;
    surface.ball.radius_m = parameters.radius_m;
    surface.ball.planeHeight_m = parameters.planeHeight_m;
    surface.fieldRadius_m = parameters.workspaceRadius_m + kMargin_m;
    surface.shown = state.objectShown;
    if (!state.objectShown)
        return surface;
    surface.ball.centre_m = state.p_WObject.head<2>();
    // An object outside the workspace (in a recording of another level) is drawn as well.
    surface.fieldRadius_m =
        std::max(surface.fieldRadius_m, surface.ball.centre_m.norm() + parameters.radius_m + 0.5 * kMargin_m);
    if (parameters.surface != simulation::ApexSurface::exact) {
        surface.mesh = simulation::apexDomeSource(parameters);
        // The scene publishes the dome as a body that can be turned, because its bumps lie elsewhere in each
        // trial.
        const auto& q = state.exercise.of<core::LaparoscopyCues>().body[0].q_W;
        surface.turn_rad = 2.0 * std::atan2(q[3], q[0]);
    }
    if (state.dimpleShown)
        surface.dimple = {parameters.dimpleDepth_m, parameters.dimpleRadius_m, state.dimpleCentre_m};
    return surface;
}

double ApexSurface::height_m(double x_m, double y_m) const {
    if (!shown)
        return ball.planeHeight_m;
    const double beside2 = (core::Vec2(x_m, y_m) - ball.centre_m).squaredNorm();
    // The contact adds the micro-height to the depth, so the surface is at distance = h.
    const double reach = ball.radius_m + dimple.sample(x_m, y_m).height_m;
    if (beside2 >= reach * reach)
        return ball.planeHeight_m;
    return ball.planeHeight_m + std::sqrt(reach * reach - beside2);
}

core::Vec3 ApexSurface::pointOfBall(const core::Vec3& u) const {
    const core::Vec3 centre(ball.centre_m.x(), ball.centre_m.y(), ball.planeHeight_m);
    double reach = ball.radius_m;
    if (dimple.depth_m == 0.0)
        return centre + reach * u;
    for (int i = 0; i < 24; ++i) // this iteration is a contraction because the dimple is shallow
        reach =
            ball.radius_m + dimple.sample(centre.x() + reach * u.x(), centre.y() + reach * u.y()).height_m;
    return centre + reach * u;
}

core::Vec3 ApexSurface::normalAt(const core::Vec3& p_W) const {
    if (!shown)
        return core::Vec3::UnitZ();
    simulation::HemisphereContact::Parameters contact;
    contact.surface = ball;
    contact.dimple = dimple;
    return simulation::HemisphereContact(contact).respond(p_W, core::Vec3::Zero()).normal;
}

Dent ApexSurface::dentUnder(const core::Vec3& p_WT) const {
    Dent dent;
    if (!shown || !p_WT.allFinite())
        return dent;
    simulation::HemisphereContact::Parameters contact;
    contact.surface = ball;
    contact.dimple = dimple;
    const auto felt = simulation::HemisphereContact(contact).respond(p_WT, core::Vec3::Zero());
    if (!felt.inContact)
        return dent;
    dent.p_WSurface = felt.surfacePoint;
    dent.normal = (felt.surfacePoint - p_WT) / felt.depth_m;
    dent.depth_m = felt.depth_m;
    dent.reach_m = Dent::kBaseReach_m + Dent::kReachPerDepth * felt.depth_m;
    return dent;
}

Dent ApexSurface::dentUnder(const ToolView& tool) const {
    if (!mesh)
        return dentUnder(tool.p_WT);
    const core::Vec3 pressed = tool.p_WProxy - tool.p_WT;
    const double depth_m = pressed.norm();
    Dent dent;
    if (!shown || !(depth_m > 1e-6))
        return dent;
    dent.p_WSurface = tool.p_WProxy;
    dent.normal = pressed / depth_m;
    dent.depth_m = depth_m;
    dent.reach_m = Dent::kBaseReach_m + Dent::kReachPerDepth * depth_m;
    return dent;
}

bool ApexSurface::operator==(const ApexSurface& other) const {
    const bool sameMesh =
        mesh.has_value() == other.mesh.has_value() &&
        (!mesh || (mesh->seed == other.mesh->seed && mesh->edge_m == other.mesh->edge_m &&
                   mesh->bumpHeight_m == other.mesh->bumpHeight_m &&
                   mesh->bumpWavelength_m == other.mesh->bumpWavelength_m && turn_rad == other.turn_rad));
    return sameMesh && shown == other.shown && fieldRadius_m == other.fieldRadius_m &&
           ball.radius_m == other.ball.radius_m && ball.planeHeight_m == other.ball.planeHeight_m &&
           ball.centre_m == other.ball.centre_m && dimple.depth_m == other.dimple.depth_m &&
           dimple.halfWidth_m == other.dimple.halfWidth_m && dimple.centre_m == other.dimple.centre_m;
}

} // namespace chiron::scene3d
