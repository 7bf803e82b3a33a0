// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep/true_contact.h"

#include "core/laparoscopy_cues.h"
#include "modules/exercises/comparison/simulation/comparison_parameters.h"
#include "modules/exercises/comparison/simulation/comparison_scene.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_plan.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_scene.h"
#include "modules/exercises/object_handling/simulation/object_handling_scene.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_plan.h"
#include "modules/exercises/sphere_apex/simulation/touched_dome.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"
#include "simulation/deformable/deformable_organ.h"
#include "simulation/geometry/mesh/make_mesh.h"
#include "sweep/triangle_distance.h"

#include <QtGlobal>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace chiron::tests {

namespace {

using core::Vec3;
using simulation::SceneInput;
using simulation::SceneOutput;

constexpr double kMeshTolerance_m = 2e-4;

bool objectsPresent(const SceneOutput& out) {
    return out.phase == core::TrialPhase::ready || out.phase == core::TrialPhase::running;
}

/// How far a rough surface may rise above its middle: 64 waves, rms √(2 · 64) (models.md §2.2).
double riseOf(double rms_m) {
    return rms_m * std::sqrt(2.0 * 64.0);
}

const simulation::DeformableOrgan* organOf(simulation::IScene& scene) {
    return dynamic_cast<const simulation::DeformableOrgan*>(scene.slowModel());
}

/// Signed distance from the surface of an organ as it is shown in this tick, in its mesh's frame.
double distanceFrom(const simulation::DeformableOrgan& organ, const Vec3& p) {
    const simulation::TriangleMesh& rest = organ.restMesh();
    std::vector<Vec3> places; // once each: they are blended anew whenever they are asked for
    places.reserve(rest.vertices().size());
    for (std::uint32_t vertex = 0; vertex < rest.vertices().size(); ++vertex)
        places.push_back(organ.position(vertex));
    return signedDistance_m(
        rest.triangles(), [&places](std::uint32_t vertex) -> const Vec3& { return places[vertex]; }, p,
        rest.longestEdge_m() + 2.0 * organ.largestDisplacement_m());
}

/// A ball on a plane; on the levels on meshes, the triangles of the dome and the plane about it.
class TrueDome final : public TrueContact {
public:
    TrueDome(const simulation::SphereApexParameters& p, std::uint64_t seed, simulation::IScene& scene)
        : m_p(p), m_trials(simulation::planSphereApexTrials(p, seed)), m_organ(organOf(scene)) {
        if (p.surface != simulation::ApexSurface::mesh)
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
        if (m_p.surface == simulation::ApexSurface::exact)
            return std::min(q.z(), q.norm() - m_p.radius_m);
        if (!(q.z() > 0.0))
            return q.z();
        const double c = std::cos(trial.turn_rad), s = std::sin(trial.turn_rad);
        const Vec3 turned(c * q.x() + s * q.y(), c * q.y() - s * q.x(), q.z()); // back by the trial's turn
        return std::min(q.z(), fromDome_m(turned)) - riseOf(m_p.roughness_m);
    }
    double tolerance_m() const override {
        return m_p.surface == simulation::ApexSurface::exact ? TrueContact::tolerance_m() : kMeshTolerance_m;
    }

private:
    double fromDome_m(const Vec3& p) const {
        if (m_organ != nullptr)
            return distanceFrom(*m_organ, p);
        return signedDistance_m(
            m_mesh->triangles(),
            [this](std::uint32_t vertex) -> const Vec3& { return m_mesh->position(vertex); }, p,
            m_mesh->longestEdge_m());
    }
    simulation::SphereApexParameters m_p;
    std::vector<simulation::SphereApexTrial> m_trials;
    const simulation::DeformableOrgan* m_organ;
    std::optional<simulation::TriangleMesh> m_mesh;
};

/// Chords between what holds the tube: it pulls where one is longer than its part of the tube. What was let
/// go of slides out of the jaws for a tenth of a second.
class TrueTube final : public TrueContact {
public:
    explicit TrueTube(const simulation::ElasticTubeParameters& p)
        : m_p(p), m_tube(simulation::elasticTubeShape(p, {})), m_fold(simulation::tissueFoldShape(p, {})) {
        m_since.fill(kSlips_ticks + 1);
    }
    void follow(const SceneInput&, const SceneOutput& out) override {
        for (std::size_t tool = 0; tool < m_since.size(); ++tool)
            m_since[tool] = holds(tool, out) ? 0 : m_since[tool] + 1;
    }
    double clearance_m(std::size_t tool, const SceneInput&, const SceneOutput& out) override {
        if (m_since[tool] > 0)
            return m_since[tool] > kSlips_ticks ? kNothing_m : -1.0;
        const core::LaparoscopyCues& cues = out.cues.exercise.of<core::LaparoscopyCues>();
        if (isRetractor(tool))
            return cues.fold ? m_fold.length_m - (at(cues.p_WFoldEdge) - at(cues.p_WFoldBase)).norm() : -1.0;
        double slack_m = kNothing_m;
        for (std::size_t node = 0; node < m_tube.nodes; ++node)
            if ((gripOf(node, out) & bit(tool)) != 0)
                slack_m = std::min(slack_m, slackAt_m(node, cues));
        return cues.grips > 0 ? slack_m : -1.0; // not shown: not known
    }
    double tolerance_m() const override { return 2e-7; } ///< a recoil that has less left is over

private:
    static constexpr int kSlips_ticks = 100;
    static unsigned bit(std::size_t tool) { return 1u << tool; }
    static Vec3 at(const std::array<double, 3>& p) { return {p[0], p[1], p[2]}; }
    bool isRetractor(std::size_t tool) const {
        return m_p.hasFold() && static_cast<int>(tool) == m_p.retractor();
    }
    static unsigned gripOf(std::size_t node, const SceneOutput& out) {
        using simulation::TubeQuantity;
        return static_cast<unsigned>(
            std::lround(out.quantities[static_cast<std::size_t>(TubeQuantity::grip0) + node]));
    }
    bool holds(std::size_t tool, const SceneOutput& out) const {
        if (isRetractor(tool))
            return (out.cues.exercise.of<core::LaparoscopyCues>().foldHeldBy & bit(tool)) != 0;
        for (std::size_t node = 0; node < m_tube.nodes; ++node)
            if ((gripOf(node, out) & bit(tool)) != 0)
                return true;
        return false;
    }
    double slackAt_m(std::size_t node, const core::LaparoscopyCues& cues) const {
        double slack_m = kNothing_m;
        for (std::size_t other = 0; other < m_tube.nodes; ++other)
            if (other != node)
                slack_m =
                    std::min(slack_m, std::abs(m_tube.share[other] - m_tube.share[node]) * m_tube.length_m -
                                          (at(cues.p_WGrip[other]) - at(cues.p_WGrip[node])).norm());
        return slack_m;
    }
    simulation::ElasticTubeParameters m_p;
    simulation::TubeShape m_tube, m_fold;
    std::array<int, core::kMaxTools> m_since{}; ///< ticks since the tool held something
};

/// A plane or the triangles of an organ on its floor, the balls on it as they lay before the tick, and what
/// the tool holds.
class TrueBed final : public TrueContact {
public:
    TrueBed(const simulation::ObjectHandlingParameters& p, simulation::IScene& scene)
        : m_p(p), m_organ(organOf(scene)) {}
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
        double clear_m = fromBed_m(p) - riseOf(m_p.bed.roughness_m);
        for (int i = 0; i < m_p.objects; ++i)
            clear_m = std::min(clear_m, (p - m_before.p_W[static_cast<std::size_t>(i)]).norm() -
                                            m_p.radius_m - riseOf(m_p.object.roughness_m));
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
        return p.z() > floor_m ? std::min(p.z() - floor_m, distanceFrom(*m_organ, p + Vec3(0.0, 0.0, lift_m)))
                               : p.z() - floor_m;
    }
    simulation::ObjectHandlingParameters m_p;
    const simulation::DeformableOrgan* m_organ;
    Bodies m_now, m_before;
};

/// Above the surface z = plane + Σ height (1 − t²)³ (models.md §3).
class TrueTissue final : public TrueContact {
public:
    explicit TrueTissue(const simulation::PalpationParameters& p) : m_shape(p.tissue.shape) {}
    double clearance_m(std::size_t tool, const SceneInput& in, const SceneOutput& out) override {
        if (!objectsPresent(out))
            return kNothing_m;
        const Vec3& p = in.tools.tools[tool].p_WT;
        double height_m = m_shape.planeHeight_m;
        for (const simulation::SurfaceBump& bump : m_shape.bumps) {
            const double c = std::cos(bump.turn_rad), s = std::sin(bump.turn_rad);
            const double dx = p.x() - bump.centre_m.x(), dy = p.y() - bump.centre_m.y();
            const double x = (c * dx + s * dy) / bump.radii_m.x(), y = (c * dy - s * dx) / bump.radii_m.y();
            const double left = 1.0 - x * x - y * y;
            height_m += left > 0.0 ? bump.height_m * left * left * left : 0.0;
        }
        return p.z() - height_m;
    }

private:
    simulation::SurfaceShape m_shape;
};

/// The patient begins where the beak's end is at the entrance, and is entered only through the meatus. The
/// canal is straight there, so that the distance from its middle is that from an axis.
class TrueCanal final : public TrueContact {
public:
    explicit TrueCanal(const simulation::UrethraInsertionParameters& p) : m_p(p) {}
    void follow(const SceneInput& in, const SceneOutput&) override {
        const Vec3 p_A = m_p.pose.pointToA(in.tools.tools[0].p_WT);
        const double z_m = p_A.z() + m_p.endoscope.beak_m, off_m = std::hypot(p_A.x(), p_A.y());
        if (z_m <= 0.0)
            m_inside = false;
        else if (m_known && m_z_m <= 0.0) {
            const double crossed_m = m_off_m - m_z_m / (z_m - m_z_m) * (off_m - m_off_m);
            m_inside = !(m_p.meatus_m > 0.0) || crossed_m <= m_p.meatus_m;
        }
        m_known = true;
        m_z_m = z_m;
        m_off_m = off_m;
    }
    double clearance_m(std::size_t tool, const SceneInput&, const SceneOutput& out) override {
        return tool == 0 && objectsPresent(out) && m_inside ? -1.0 : kNothing_m;
    }

private:
    simulation::UrethraInsertionParameters m_p;
    bool m_inside = true; ///< begun beyond the entrance: not known to be beside the canal
    bool m_known = false;
    double m_z_m = 0.0, m_off_m = 0.0;
};

/// The objects of a study: tubes that are slack within their length about their foot, objects that are taken
/// hold of at their ring, pads.
class TrueObjects final : public TrueContact {
public:
    explicit TrueObjects(const simulation::ComparisonParameters& p) : m_p(p) {
        double largest = 0.0;
        for (const auto& candidate : p.values)
            largest = std::max(largest, *std::max_element(candidate.begin(), candidate.end()));
        m_rise_m =
            riseOf(p.attribute == simulation::ComparedAttribute::roughness ? largest : p.object.roughness_m);
    }
    void follow(const SceneInput& in, const SceneOutput& out) override {
        namespace q = simulation::comparison_quantity;
        const Vec3& p = in.tools.tools[0].p_WT;
        const int felt = static_cast<int>(std::lround(out.quantities[q::kPlace])) - 1;
        for (int i = 0; i < m_p.places; ++i) {
            bool& may = m_mayHold[static_cast<std::size_t>(i)];
            const double away_m = (p - ringOf(i)).norm();
            const bool slack = isTube() ? slackOf_m(i, p) >= 0.0 : felt != i;
            if (away_m <= m_p.hookReach_m)
                may = true;
            else if (slack && away_m > m_p.hookLeave_m)
                may = false;
        }
    }
    double clearance_m(std::size_t tool, const SceneInput& in, const SceneOutput& out) override {
        double clear_m = kNothing_m;
        if (tool != 0 || !objectsPresent(out))
            return clear_m;
        const Vec3& p = in.tools.tools[0].p_WT;
        for (int i = 0; i < m_p.places; ++i) {
            const bool may = m_mayHold[static_cast<std::size_t>(i)];
            clear_m = std::min(clear_m, !simulation::isHooked(m_p.attribute) ? abovePad_m(i, p)
                                        : !may                               ? kNothing_m
                                        : isTube()                           ? slackOf_m(i, p)
                                                                             : -1.0);
        }
        return clear_m;
    }

private:
    bool isTube() const { return m_p.attribute == simulation::ComparedAttribute::stiffness; }
    Vec3 footOf(int place) const { return {simulation::placeX_m(m_p, place), 0.0, 0.0}; }
    Vec3 ringOf(int place) const { return footOf(place) + Vec3(0.0, 0.0, m_p.hookHeight_m); }
    double slackOf_m(int place, const Vec3& p) const { return m_p.hookHeight_m - (p - footOf(place)).norm(); }
    double abovePad_m(int place, const Vec3& p) const {
        const Vec3 from = p - footOf(place);
        const double out_m = std::max(0.0, std::hypot(from.x(), from.y()) - m_p.padRadius_m);
        return from.z() + 0.5 * out_m * out_m / m_p.padEdge_m - m_rise_m;
    }
    simulation::ComparisonParameters m_p;
    double m_rise_m = 0.0;
    std::array<bool, simulation::ComparisonParameters::kMaxPlaces> m_mayHold{};
};

} // namespace

std::unique_ptr<TrueContact> trueContactOf(const session::SessionSetup& setup, simulation::IScene& scene) {
    const core::ExerciseParameters& level = setup.level.parameters;
    if (const auto* apex = level.find<simulation::SphereApexParameters>())
        return std::make_unique<TrueDome>(*apex, setup.seed, scene);
    if (const auto* tube = level.find<simulation::ElasticTubeParameters>())
        return std::make_unique<TrueTube>(*tube);
    if (const auto* handling = level.find<simulation::ObjectHandlingParameters>())
        return std::make_unique<TrueBed>(*handling, scene);
    if (const auto* palpation = level.find<simulation::PalpationParameters>())
        return std::make_unique<TrueTissue>(*palpation);
    if (const auto* urethra = level.find<simulation::UrethraInsertionParameters>())
        return std::make_unique<TrueCanal>(*urethra);
    if (const auto* compared = level.find<simulation::ComparisonParameters>())
        return std::make_unique<TrueObjects>(*compared);
    return nullptr;
}

} // namespace chiron::tests
