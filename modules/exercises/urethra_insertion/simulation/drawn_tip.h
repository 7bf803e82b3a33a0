// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"

namespace chiron::simulation {

/// Determines where the tip is drawn: the endoscope must not appear to leave through the wall, however far a
/// hand without force (or stronger than the motors) has moved. Within the allowed space the drawn tip is the
/// tip itself, bit for bit. That space is up to the neck within kOffset_m of the centre-line, and past it
/// within kOffset_m of the middle or in the bladder's sphere minus the endoscope's radius. A tip outside is
/// moved towards the middle, to the border of that space. Up to the neck the middle is the foot on the
/// centre-line; past it the middle is the point as far along the bladder's axis, at most its centre. Before
/// the entrance the tip is free: the limit opens by kOpening. The result is continuous: it moves at most 4.2
/// times as far as a tip that moves along the canal, whatever its offset up to 30 mm (where the limit grows:
/// 4.1 times at the sphere's section past the neck, 3.7 times before the entrance). Pure.
/// Thread: any.
class DrawnTip {
public:
    /// The most by which the wall is drawn to yield: twice the lateral offset of 2–4 mm at which the force
    /// limits lie (models.md §1.2).
    static constexpr double kOffset_m = 0.008;
    /// Growth of the limit in m per metre before the entrance: no steeper than the sphere's section where it
    /// becomes wider than the canal's limit.
    static constexpr double kOpening = 3.5;

    DrawnTip(const UrethraInsertionParameters& parameters) noexcept;

    /// `foot` is that of p_A.
    /// Unit: m.
    /// Frame: A.
    core::Vec3 at(const core::Vec3& p_A, const CentrelineFoot& foot) const noexcept;
    /// Computes the same in W, including the foot.
    core::Vec3 inW(const core::Vec3& p_WT) const noexcept;

private:
    core::Vec3 inCanal(const core::Vec3& p_A, const CentrelineFoot& foot) const noexcept;
    core::Vec3 pastNeck(const core::Vec3& p_A, double s_m) const noexcept;
    /// 0 where the line misses the bladder.
    double wayOutOfBladder_m(const core::Vec3& from_A, const core::Vec3& way_A) const noexcept;

    UrethraCentreline m_line;
    AnatomyPose m_pose;
    CentrelinePoint m_neck;
    core::Vec3 m_bladderCentre;
    double m_bladderRadius_m;
    double m_bladderRoom_m;
    double m_beak_m;
};

} // namespace chiron::simulation
