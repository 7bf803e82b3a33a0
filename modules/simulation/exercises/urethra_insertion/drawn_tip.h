// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/exercises/urethra_insertion/urethra_insertion_parameters.h"

namespace chiron::simulation {

/// Where the tip is drawn: the endoscope cannot leave through the wall, however far a hand without force (or stronger than
/// the motors) has gone. The tip stays within kOffset_m of the centre-line's canal, or within the bladder's sphere less the
/// endoscope's radius, whichever is nearer to where the hand is; before the entrance it is free (the limit opens by 10 m a metre).
/// Pure; any thread.
class DrawnTip {
public:
    /// What the wall is drawn to yield at most: twice the lateral offset of 2–4 mm at which the force limits lie (models.md §1.2).
    static constexpr double kOffset_m = 0.008;

    DrawnTip(const UrethraInsertionParameters& parameters) noexcept;

    /// `foot` is p_A's. A, m.
    core::Vec3 at(const core::Vec3& p_A, const CentrelineFoot& foot) const noexcept;
    /// The same in W, foot and all.
    core::Vec3 inW(const core::Vec3& p_WT) const noexcept;

private:
    core::Vec3 inCanal(const core::Vec3& p_A, const CentrelineFoot& foot) const noexcept;

    UrethraCentreline m_line;
    AnatomyPose m_pose;
    CentrelinePoint m_neck;
    core::Vec3 m_bladderCentre;
    double m_bladderRoom_m;
    double m_beak_m;
};

} // namespace chiron::simulation
