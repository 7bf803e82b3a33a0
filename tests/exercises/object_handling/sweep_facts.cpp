// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep/sweep_facts.h"

#include "modules/exercises/object_handling/simulation/object_handling_scene.h"

#include <algorithm>
#include <array>
#include <utility>

namespace chiron::tests {

namespace {

using core::Vec3;
using simulation::ObjectHandlingParameters;
using simulation::SceneInput;
using simulation::SceneOutput;

/// A plane or the triangles of an organ on its floor, the balls on it as they lay before the tick, and what
/// the tool holds.
class TrueBed final : public TrueContact {
public:
    TrueBed(const ObjectHandlingParameters& p, simulation::IScene& scene) : m_p(p), m_organ(organOf(scene)) {}
    void follow(const SceneInput&, const SceneOutput& out) override {
        namespace q = simulation::handling_quantity;
        m_before = m_now;
        m_now = {};
        m_now.known = objectsPresent(out);
        m_now.holds = out.quantities[q::kHeld] > 0.0;
        for (std::size_t i = 0; i < m_now.p_W.size(); ++i)
            for (int axis = 0; axis < 3; ++axis)
                m_now.p_W[i][axis] = out.quantities[q::kBodies + 3 * i + static_cast<std::size_t>(axis)];
    }
    double clearance_m(std::size_t tool, const SceneInput& in, const SceneOutput& out) override {
        if (tool != 0 || !objectsPresent(out))
            return kNothing_m;
        if (!m_before.known || m_before.holds || m_now.holds)
            return -1.0;
        const Vec3& p = in.tools.tools[0].p_WT;
        double clear_m = fromBed_m(p) - roughRise_m(m_p.bed.roughness_m);
        for (int i = 0; i < m_p.objects; ++i)
            clear_m = std::min(clear_m, (p - m_before.p_W[static_cast<std::size_t>(i)]).norm() -
                                            m_p.radius_m - roughRise_m(m_p.object.roughness_m));
        return clear_m;
    }
    double tolerance_m() const override {
        return m_organ != nullptr ? kMeshTolerance_m : TrueContact::tolerance_m();
    }

private:
    struct Bodies {
        bool known = false;
        bool holds = false;
        std::array<Vec3, simulation::ObjectHandlingTrial::kMaxObjects> p_W{Vec3::Zero(), Vec3::Zero(),
                                                                           Vec3::Zero()};
    };
    double fromBed_m(const Vec3& p) const {
        if (m_organ == nullptr)
            return p.z();
        const simulation::TriangleMesh& rest = m_organ->restMesh();
        const double lift_m = rest.highest().z(), floor_m = rest.lowest().z() - lift_m;
        return p.z() > floor_m
                   ? std::min(p.z() - floor_m, distanceFrom_m(*m_organ, p + Vec3(0.0, 0.0, lift_m)))
                   : p.z() - floor_m;
    }
    ObjectHandlingParameters m_p;
    const simulation::DeformableOrgan* m_organ;
    Bodies m_now, m_before;
};

StatedLaw lawOf(std::string name, bool organBed) {
    ObjectHandlingParameters handling;
    handling.organBed = organBed;
    handling.bedMesh.shape = simulation::MeshSource::Shape::ellipsoid;
    handling.bedMesh.edge_m = 0.004;
    return {std::move(name), !organBed, simulation::ObjectHandlingScene(handling, 1).conservative()};
}

class ObjectHandlingFacts final : public SweepFacts {
public:
    ObjectHandlingFacts() : SweepFacts("object_handling") {}

    void complete(const catalogue::ExerciseLevel& level, LevelNumbers& numbers) const override {
        const auto& p = level.parameters.as<ObjectHandlingParameters>();
        addSurface(numbers, p.object);
        addSurface(numbers, p.bed);
    }
    std::unique_ptr<TrueContact> trueContact(const session::SessionSetup& setup,
                                             simulation::IScene& scene) const override {
        return std::make_unique<TrueBed>(setup.level.parameters.as<ObjectHandlingParameters>(), scene);
    }
    std::vector<StatedLaw> laws() const override {
        return {lawOf("a plane", false), lawOf("an organ", true)};
    }
};

const ObjectHandlingFacts kFacts;

} // namespace

} // namespace chiron::tests
