// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/urethra/urethra_section.h"
#include "simulation/geometry/urethra/urethra_surface.h"
#include "simulation/geometry/urethra/urethra_wall.h"

#include <span>
#include <vector>

namespace chiron::simulation {

/// Which sections the drawn urethra has at an instant (models.md §1.1): from A on the basic sections, opened
/// and shifted as the endoscope asks, merged with the moving ones from the tip to the end of the deformation,
/// s_t + ℓ. Nothing deformed: no sections. Otherwise the list ends on the resting surface (its last section
/// says where), or at C.
class UrethraSectionPlan {
public:
    /// A moving section this near a basic one is nudged away from it: coincident sections give 0/0, merged
    /// ones a jump.
    static constexpr double kNudge_m = 1e-6;

    /// `basic_s_m`: arc lengths of the basic sections, ascending from 0 to L; they outlive the plan.
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
    UrethraSection m_end; ///< with restSpan −1 where the deformation reaches C
    std::vector<UrethraSection> m_sections;
};

} // namespace chiron::simulation
