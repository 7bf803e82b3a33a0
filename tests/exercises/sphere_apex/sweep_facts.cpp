// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep/sweep_facts.h"

#include "modules/exercises/sphere_apex/simulation/sphere_apex_plan.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_scene.h"
#include "modules/exercises/sphere_apex/simulation/touched_dome.h"
#include "simulation/geometry/mesh/make_mesh.h"
#include "sweep/triangle_distance.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace chiron::tests {

namespace {

using core::Vec3;
using simulation::ApexSurface;
using simulation::SceneInput;
using simulation::SceneOutput;
using simulation::SphereApexParameters;

/// A ball on a plane; on the levels on meshes, the triangles of the dome and the plane about it.
class TrueDome final : public TrueContact {
public:
    TrueDome(const SphereApexParameters& p, std::uint64_t seed, simulation::IScene& scene)
        : m_p(p), m_trials(simulation::planSphereApexTrials(p, seed)), m_organ(organOf(scene)) {
        if (p.surface != ApexSurface::mesh)
            return;
        auto mesh = simulation::makeMesh(simulation::apexDomeSource(p));
        if (!mesh)
            qFatal("%s", mesh.error().message.c_str());
        m_mesh = std::move(*mesh);
    }
    double clearance_m(std::size_t tool, const SceneInput& in, const SceneOutput& out) override {
        if (!objectsPresent(out))
            return kNothing_m;
        const simulation::SphereApexTrial& trial = m_trials[out.trial];
        const Vec3 q =
            in.tools.tools[tool].p_WT - Vec3(trial.centre_m.x(), trial.centre_m.y(), m_p.planeHeight_m);
        if (m_p.surface == ApexSurface::exact)
            return std::min(q.z(), q.norm() - m_p.radius_m);
        if (!(q.z() > 0.0))
            return q.z();
        const double c = std::cos(trial.turn_rad), s = std::sin(trial.turn_rad);
        const Vec3 turned(c * q.x() + s * q.y(), c * q.y() - s * q.x(), q.z()); // back by the trial's turn
        return std::min(q.z(), fromDome_m(turned)) - roughRise_m(m_p.roughness_m);
    }
    double tolerance_m() const override {
        return m_p.surface == ApexSurface::exact ? TrueContact::tolerance_m() : kMeshTolerance_m;
    }

private:
    double fromDome_m(const Vec3& p) const {
        if (m_organ != nullptr)
            return distanceFrom_m(*m_organ, p);
        return signedDistance_m(
            m_mesh->triangles(),
            [this](std::uint32_t vertex) -> const Vec3& { return m_mesh->position(vertex); }, p,
            m_mesh->longestEdge_m());
    }
    SphereApexParameters m_p;
    std::vector<simulation::SphereApexTrial> m_trials;
    const simulation::DeformableOrgan* m_organ;
    std::optional<simulation::TriangleMesh> m_mesh;
};

StatedLaw lawOf(std::string name, ApexSurface surface) {
    SphereApexParameters dome;
    dome.surface = surface;
    dome.meshEdge_m = 0.004;
    dome.trials = 1;
    return {std::move(name), surface == ApexSurface::exact,
            simulation::SphereApexScene(dome, 1).conservative()};
}

class SphereApexFacts final : public SweepFacts {
public:
    SphereApexFacts() : SweepFacts("sphere_apex") {}

    void complete(const catalogue::ExerciseLevel& level, LevelNumbers& numbers) const override {
        const auto& p = level.parameters.as<SphereApexParameters>();
        numbers.friction = p.frictionHigh;
        numbers.bristle_N_per_m = p.frictionHigh > 0.0 ? p.bristleStiffness_N_per_m : 0.0;
        if (p.surface != ApexSurface::exact)
            numbers.rough_per_m = roughCurvature_per_m(p.roughness_m, p.roughnessWavelength_m);
    }
    std::unique_ptr<TrueContact> trueContact(const session::SessionSetup& setup,
                                             simulation::IScene& scene) const override {
        return std::make_unique<TrueDome>(setup.level.parameters.as<SphereApexParameters>(), setup.seed,
                                          scene);
    }
    std::vector<StatedLaw> laws() const override {
        return {lawOf("a ball", ApexSurface::exact), lawOf("a mesh", ApexSurface::mesh),
                lawOf("an organ", ApexSurface::organ)};
    }
    /// Through the soft organ, until what is felt of a mesh had a bound (felt_place.h).
    std::vector<FormerJump> formerJumps() const override {
        constexpr int kOrgan = 6;
        return {{"another sheet, 6 mm deep: 3.6 N", kOrgan, 13503906239192, 140},
                {"another sheet, 4.4 mm deep: 2.6 N", kOrgan, 17230532855949, 120},
                {"another sheet, 1.8 mm deep: 1.05 N", kOrgan, 14497812207606, 120},
                {"the normal turns under a deep tool: 0.21 N", kOrgan, 8678721026058, 0},
                {"the organ moves under a still tool: 0.13 N", kOrgan, 24069354330247, 20},
                {"it turns under a press: 0.26 N", kOrgan, 17566737335040, 60}};
    }
};

const SphereApexFacts kFacts;

} // namespace

} // namespace chiron::tests
