// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/level_units.h"

#include "desktop/studies/study_words.h"

#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {
constexpr double kPercent = 100.0;
constexpr double kSmallest_percent = 0.001;
} // namespace

double LevelUnits::percentOf(double x) const {
    return kPercent * study_words::ratioOf(m_logarithm ? std::pow(10.0, x) : x);
}

double LevelUnits::xOf(double percent) const {
    if (!m_logarithm)
        return study_words::differenceOf(std::max(percent, kSmallest_percent - kPercent) / kPercent);
    return std::log10(study_words::differenceOf(std::max(percent, kSmallest_percent) / kPercent));
}

double LevelUnits::lowestPercent() const {
    constexpr double kSmallestShown_percent = 0.01; // fields have two decimals
    constexpr double kAlmostNothing_percent = -99.0;
    return m_logarithm ? kSmallestShown_percent : kAlmostNothing_percent;
}

double LevelUnits::spreadOf(double distance) const {
    return m_logarithm ? std::pow(10.0, distance) : kPercent * study_words::ratioOf(distance);
}

double LevelUnits::distanceOf(double spread) const {
    return m_logarithm ? std::log10(std::max(spread, 1.0))
                       : study_words::differenceOf(std::max(spread, 0.0) / kPercent);
}

} // namespace chiron::desktop
