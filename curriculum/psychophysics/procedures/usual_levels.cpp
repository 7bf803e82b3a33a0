// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/procedures/usual_levels.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {

std::vector<double> usualLevels(const Condition& condition) {
    std::vector<double> levels;
    for (const double difference : condition.stimulus.differences) {
        if (condition.scale == ProcedureScale::difference)
            levels.push_back(difference);
        else if (difference > kSmallestDifference)
            levels.push_back(std::log10(difference));
    }
    if (levels.empty())
        levels.push_back(condition.scale == ProcedureScale::difference ? 0.1 : -1.0);
    return levels;
}

double guessRateOf(Task task) {
    switch (task) {
    case Task::threeAfc:
    case Task::oddity:
        return 1.0 / 3.0;
    case Task::twoAfc:
        return 0.5;
    case Task::rank3:
    case Task::rank3Ties:
        return 1.0 / 6.0;
    case Task::sameDifferent:
    case Task::yesNo:
    case Task::adjustment:
    case Task::magnitude:
        break;
    }
    return 0.0;
}

std::vector<double> evenGrid(double low, double high, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
        values.push_back(low + (high - low) * i / std::max(1, count - 1));
    return values;
}

std::vector<double> someOf(const std::vector<double>& values, std::size_t most) {
    if (values.size() <= most)
        return values;
    std::vector<double> some;
    for (std::size_t i = 0; i < most; ++i)
        some.push_back(values[i * (values.size() - 1) / (most - 1)]);
    return some;
}

} // namespace chiron::psychophysics
