// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/study_design.h"

namespace chiron::desktop {

/// What a procedure works on, in what a researcher thinks in: differences in per cent of the reference, steps and spreads of them. A procedure's
/// x is D (log10 of the ratio to the reference) or log10 of D.
class LevelUnits {
public:
    explicit LevelUnits(psychophysics::ProcedureScale scale) : m_logarithm(scale == psychophysics::ProcedureScale::logDifference) {}

    double percentOf(double x) const;
    double xOf(double percent) const; ///< of a logarithm the least that has one, where `percent` has none

    /// A distance on x: of a logarithm a factor of the difference (0.1 is × 1.26), else a difference in per cent.
    double spreadOf(double distance) const;
    double distanceOf(double spread) const;
    bool spreadIsFactor() const { return m_logarithm; }

private:
    bool m_logarithm;
};

} // namespace chiron::desktop
