// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/urethra/urethra_curves.h"
#include "simulation/geometry/urethra/urethra_section_plan.h"

#include <vector>

namespace chiron::simulation {

/// A point of the drawn surface.
struct UrethraSurfacePoint {
    core::Vec3 p_A = core::Vec3::Zero();
    core::Vec3 n_A = core::Vec3::Zero(); ///< unit, towards the lumen's axis
};

/// The drawn urethra in double precision: its resting curves, and the curves of the sections that the
/// endoscope has opened, shifted or added. The float surface is made from it; tests and the command line
/// evaluate it directly.
/// Thread: a single one.
class UrethraCurveNet {
public:
    UrethraCurveNet(const UrethraAnatomy& anatomy, const Endoscope& endoscope,
                    const UrethraMeshSettings& settings);
    UrethraCurveNet(const UrethraCurveNet&) = delete;
    UrethraCurveNet& operator=(const UrethraCurveNet&) = delete;

    /// Returns the first span of the deformed curves that differs from before (all later spans may differ).
    int deform(const UrethraDeformation& deformation);
    int deformAnew(const UrethraDeformation& deformation); ///< recomputes everything; returns 0

    const UrethraCurves& rest() const noexcept { return m_rest; }
    /// Has no sections while the urethra is at rest.
    const UrethraCurves& deformed() const noexcept { return m_deformed; }
    const UrethraSectionPlan& plan() const noexcept { return m_plan; }
    const UrethraCentreline& centreline() const noexcept { return m_centreline; }

    /// The surface at arc length s (clamped to 0 … L) and at an angle about the canal, measured from x̂
    /// towards n. Both are the surface's own parameters: linear in s within a span and in the angle within a
    /// patch. Normals are averaged over patch edges.
    UrethraSurfacePoint at(double s_m, double angle_rad) const noexcept;

private:
    UrethraCentreline m_centreline;
    UrethraWall m_wall;
    std::vector<double> m_basic_s_m;
    std::vector<CentrelinePoint> m_basicAt;
    UrethraSectionPlan m_plan;
    UrethraCurves m_rest;
    UrethraCurves m_deformed;
    std::vector<UrethraSection> m_placed; ///< the sections from which m_deformed was made
};

} // namespace chiron::simulation
