// SPDX-License-Identifier: GPL-3.0-or-later
#include "sweep/sweep_facts.h"

#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"
#include "simulation/geometry/urethra/urethra_anatomy.h"
#include "simulation/geometry/urethra/urethra_centreline.h"

#include <algorithm>
#include <cmath>

namespace chiron::tests {

namespace {

using core::Vec3;
using simulation::SceneInput;
using simulation::SceneOutput;
using simulation::UrethraInsertionParameters;

/// The patient begins where the beak's end is at the entrance, and is entered only through the meatus. The
/// canal is straight there, so that the distance from its middle is that from an axis.
class TrueCanal final : public TrueContact {
public:
    explicit TrueCanal(const UrethraInsertionParameters& p) : m_p(p) {}
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
    UrethraInsertionParameters m_p;
    bool m_inside = true; ///< begun beyond the entrance: not known to be beside the canal
    bool m_known = false;
    double m_z_m = 0.0, m_off_m = 0.0;
};

/// The canal turns the endoscope.
void addTurning(const UrethraInsertionParameters& p, double length_m, LevelNumbers& numbers) {
    constexpr double kMostTwist_rad = 1.5;
    const simulation::UrethraAnatomy& anatomy = p.anatomy;
    const double span_m = anatomy.pivotSpan_m, turning_m = length_m - anatomy.straight_m;
    numbers.turn_Nm_per_rad = anatomy.angularStiffness_Nm_per_rad;
    numbers.turn_Nm_per_m =
        numbers.turn_Nm_per_rad *
        (2.0 * anatomy.curvature_per_m + (span_m > 0.0 ? 0.5 / span_m : 0.0) + kMostTwist_rad / turning_m);
    numbers.shaft_m = p.endoscope.radius_m;
}

class UrethraInsertionFacts final : public SweepFacts {
public:
    UrethraInsertionFacts() : SweepFacts("urethra_insertion") {}

    void complete(const catalogue::ExerciseLevel& level, LevelNumbers& numbers) const override {
        const auto& p = level.parameters.as<UrethraInsertionParameters>();
        const simulation::UrethraCentreline line(p.anatomy);
        double factor = 1.0;
        for (std::size_t i = 0; i < p.anatomy.changeCount; ++i)
            factor = std::max(factor, p.anatomy.changes[i].frictionFactor);
        numbers.friction = p.anatomy.friction * factor;
        addTurning(p, line.length_m(), numbers);
        // Nobody meets a meatus by chance: along the canal and out again.
        for (const double s_m : {-0.012, -0.004, 0.010, 0.030, 0.050, 0.070, 0.090, 0.110, line.length_m(),
                                 line.length_m() + 0.015})
            numbers.way_W.push_back(p.pose.pointToW(line.at(s_m).p_A));
    }
    std::unique_ptr<TrueContact> trueContact(const session::SessionSetup& setup,
                                             simulation::IScene&) const override {
        return std::make_unique<TrueCanal>(setup.level.parameters.as<UrethraInsertionParameters>());
    }
};

const UrethraInsertionFacts kFacts;

} // namespace

} // namespace chiron::tests
