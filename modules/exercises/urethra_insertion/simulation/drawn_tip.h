// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"

namespace chiron::simulation {

/// Where the tip is drawn: the endoscope cannot leave through the wall, however far a hand without force (or stronger than
/// the motors) has gone. In the allowed room it is the tip itself, bit for bit: up to the neck within kOffset_m of the
/// centre-line, past it within kOffset_m of the middle or in the bladder's sphere less the endoscope's radius. From outside it is drawn
/// back to that room's border towards the middle: the foot on the centre-line up to the neck, past it the point as far along the
/// bladder's axis, at most its centre. Before the entrance it is free: the limit opens by kOpening.
/// Continuous: a tip that moves along the canal moves the drawn one at most 4.2 times as far, whatever its offset to
/// 30 mm (where the limit grows: the sphere's section past the neck 4.1 times, before the entrance 3.7).
/// Pure; any thread.
class DrawnTip {
public:
    /// What the wall is drawn to yield at most: twice the lateral offset of 2–4 mm at which the force limits lie (models.md §1.2).
    static constexpr double kOffset_m = 0.008;
    /// m a metre before the entrance: no steeper than the sphere's section where it becomes wider than the canal's limit.
    static constexpr double kOpening = 3.5;

    DrawnTip(const UrethraInsertionParameters& parameters) noexcept;

    /// `foot` is p_A's. A, m.
    core::Vec3 at(const core::Vec3& p_A, const CentrelineFoot& foot) const noexcept;
    /// The same in W, foot and all.
    core::Vec3 inW(const core::Vec3& p_WT) const noexcept;

private:
    core::Vec3 inCanal(const core::Vec3& p_A, const CentrelineFoot& foot) const noexcept;
    core::Vec3 pastNeck(const core::Vec3& p_A, double s_m) const noexcept;
    double wayOutOfBladder_m(const core::Vec3& from_A, const core::Vec3& way_A) const noexcept; ///< 0 where it is missed

    UrethraCentreline m_line;
    AnatomyPose m_pose;
    CentrelinePoint m_neck;
    core::Vec3 m_bladderCentre;
    double m_bladderRadius_m;
    double m_bladderRoom_m;
    double m_beak_m;
};

} // namespace chiron::simulation
