// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/study_design.h"

namespace chiron::desktop {

/// Converts the variable x of a procedure into units that researchers use: differences in per cent of the
/// reference, and steps and spreads of them. The x of a procedure is D (log10 of the ratio to the reference)
/// or log10 of D.
class LevelUnits {
public:
    explicit LevelUnits(psychophysics::ProcedureScale scale)
        : m_logarithm(scale == psychophysics::ProcedureScale::logDifference) {}

    double percentOf(double x) const;
    /// On a logarithmic scale, values without a logarithm give the smallest representable x.
    double xOf(double percent) const;

    /// Converts a distance on x: on a logarithmic scale into a factor of the difference (0.1 is × 1.26), else
    /// into a difference in per cent.
    double spreadOf(double distance) const;
    double distanceOf(double spread) const;
    /// The smallest difference that a field offers: a logarithm has none of 0 or below.
    double lowestPercent() const;
    bool spreadIsFactor() const { return m_logarithm; }

private:
    bool m_logarithm;
};

} // namespace chiron::desktop
