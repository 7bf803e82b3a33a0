// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep/sweep_facts.h"

#include "cues/laparoscopy_cues.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_plan.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_scene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace chiron::tests {

namespace {

using core::Vec3;
using simulation::ElasticTubeParameters;
using simulation::SceneInput;
using simulation::SceneOutput;

/// Chords between what holds the tube: it pulls where one is longer than its part of the tube. What was let
/// go of slides out of the jaws for a tenth of a second.
class TrueTube final : public TrueContact {
public:
    explicit TrueTube(const ElasticTubeParameters& p)
        : m_p(p), m_tube(simulation::elasticTubeShape(p, {})), m_fold(simulation::tissueFoldShape(p, {})) {
        m_since.fill(kSlips_ticks + 1);
    }
    void follow(const SceneInput&, const SceneOutput& out) override {
        for (std::size_t tool = 0; tool < m_since.size(); ++tool)
            m_since[tool] = holds(tool, out) ? 0 : m_since[tool] + 1;
    }
    double clearance_m(std::size_t tool, const SceneInput&, const SceneOutput& out) override {
        if (m_since[tool] > 0)
            return slides(tool) ? -1.0 : kNothing_m;
        const core::LaparoscopyCues& cues = out.cues.exercise.of<core::LaparoscopyCues>();
        if (isRetractor(tool))
            return cues.fold ? m_fold.length_m - (at(cues.p_WFoldEdge) - at(cues.p_WFoldBase)).norm() : -1.0;
        double slack_m = kNothing_m;
        for (std::size_t node = 0; node < m_tube.nodes; ++node)
            if ((gripOf(node, out) & bit(tool)) != 0)
                slack_m = std::min(slack_m, slackAt_m(node, cues));
        return cues.grips > 0 ? slack_m : -1.0; // not shown: not known
    }
    bool slides(std::size_t tool) const override {
        return m_since[tool] > 0 && m_since[tool] <= kSlips_ticks;
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
    ElasticTubeParameters m_p;
    simulation::TubeShape m_tube, m_fold;
    std::array<int, core::kMaxTools> m_since{}; ///< ticks since the tool held something
};

/// Tubes neither rub nor are they rough.
class ElasticTubeFacts final : public SweepFacts {
public:
    ElasticTubeFacts() : SweepFacts("elastic_tube") {}

    std::unique_ptr<TrueContact> trueContact(const session::SessionSetup& setup,
                                             simulation::IScene&) const override {
        return std::make_unique<TrueTube>(setup.level.parameters.as<ElasticTubeParameters>());
    }
};

const ElasticTubeFacts kFacts;

} // namespace

} // namespace chiron::tests
