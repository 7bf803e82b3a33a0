// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/urethra/urethra_section.h"
#include "simulation/geometry/urethra/urethra_surface.h"
#include "simulation/geometry/urethra/urethra_wall.h"

#include <span>
#include <vector>

namespace chiron::simulation {

/// Determines which sections the drawn urethra has at an instant (models.md §1.1): the basic sections from A
/// on, opened and shifted by the endoscope, merged with the moving ones from the tip to the end of the
/// deformation, s_t + ℓ. There are no sections if nothing is deformed. Otherwise the list ends on the resting
/// surface (its last section says where), or at C.
class UrethraSectionPlan {
public:
    /// A moving section that is this near to a basic one is nudged away from it: coincident sections would
    /// give 0/0, and merging them would cause a jump.
    static constexpr double kNudge_m = 1e-6;

    /// `basic_s_m` holds the arc lengths of the basic sections, ascending from 0 to L; the array must outlive
    /// the plan.
    UrethraSectionPlan(const UrethraWall& wall, std::span<const double> basic_s_m, int movingSections);

    void make(const UrethraDeformation& deformation);

    const std::vector<UrethraSection>& sections() const noexcept { return m_sections; }
    bool endsOnRest() const noexcept { return !m_sections.empty() && m_sections.back().restSpan >= 0; }
    UrethraSection basicAtRest(int index) const noexcept;

private:
    void findEnd(double end_s_m) noexcept;
    void addMovingBefore(double s_m, int& next);
    double movingAt(int index) const noexcept;
    UrethraSection opened(double s_m) const noexcept;

    const UrethraWall& m_wall;
    std::span<const double> m_basic_s_m;
    int m_movingSections;
    UrethraDeformation m_deformation;
    UrethraSection m_end; ///< restSpan is −1 where the deformation reaches C
    std::vector<UrethraSection> m_sections;
};

} // namespace chiron::simulation
