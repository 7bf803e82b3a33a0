// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep/sweep_facts.h"

#include "modules/exercises/palpation/simulation/palpation_scene.h"

#include <array>
#include <cmath>
#include <utility>

namespace chiron::tests {

namespace {

using core::Vec3;
using simulation::LumpLaw;
using simulation::PalpationParameters;
using simulation::SceneInput;
using simulation::SceneOutput;
using simulation::TissueContactLaw;

/// Above the surface z = plane + Σ height (1 − t²)³ (models.md §3).
class TrueTissue final : public TrueContact {
public:
    explicit TrueTissue(const PalpationParameters& p) : m_shape(p.tissue.shape) {}
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

StatedLaw lawOf(const std::string& contactName, TissueContactLaw contact, const std::string& lumpsName,
                LumpLaw lumps) {
    PalpationParameters palpation;
    palpation.tissue.contact = contact;
    palpation.tissue.lumps = lumps;
    return {contactName + ", " + lumpsName,
            contact == TissueContactLaw::anchored && lumps != LumpLaw::stiffnessTimesDepth,
            simulation::PalpationScene(palpation, 1).conservative()};
}

class PalpationFacts final : public SweepFacts {
public:
    PalpationFacts() : SweepFacts("palpation") {}

    /// The tissue's bristle is a part of the stiffness that the scene reports.
    void complete(const catalogue::ExerciseLevel& level, LevelNumbers& numbers) const override {
        numbers.friction = level.parameters.as<PalpationParameters>().tissue.friction;
    }
    std::unique_ptr<TrueContact> trueContact(const session::SessionSetup& setup,
                                             simulation::IScene&) const override {
        return std::make_unique<TrueTissue>(setup.level.parameters.as<PalpationParameters>());
    }
    std::vector<StatedLaw> laws() const override {
        std::vector<StatedLaw> laws;
        for (const auto& [contactName, contact] :
             {std::pair{"anchored", TissueContactLaw::anchored}, {"cast again", TissueContactLaw::p3Recast}})
            for (const auto& [lumpsName, lumps] : {std::pair{"inclusion", LumpLaw::inclusion},
                                                   {"second surface", LumpLaw::secondSurface},
                                                   {"stiffness times depth", LumpLaw::stiffnessTimesDepth}})
                laws.push_back(lawOf(contactName, contact, lumpsName, lumps));
        return laws;
    }
};

const PalpationFacts kFacts;

} // namespace

} // namespace chiron::tests
