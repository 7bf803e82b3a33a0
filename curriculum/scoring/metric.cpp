// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/metric.h"

namespace chiron::scoring {

std::string_view toString(Direction direction) {
    switch (direction) {
    case Direction::lowerIsBetter:
        return "lower";
    case Direction::higherIsBetter:
        return "higher";
    case Direction::neutral:
        break;
    }
    return "neutral";
}

std::string_view toString(MetricWrench wrench) {
    switch (wrench) {
    case MetricWrench::tissue:
        return "tissue";
    case MetricWrench::commanded:
        return "commanded";
    case MetricWrench::measured:
        return "measured";
    case MetricWrench::none:
        break;
    }
    return "none";
}

std::string_view toString(Aggregate aggregate) {
    switch (aggregate) {
    case Aggregate::sum:
        return "sum";
    case Aggregate::mean:
        return "mean";
    case Aggregate::median:
        return "median";
    case Aggregate::maximum:
        return "maximum";
    case Aggregate::pooled:
        break;
    }
    return "pooled";
}

std::string_view toString(MetricTools tools) {
    return tools == MetricTools::all ? "all" : "first";
}

} // namespace chiron::scoring
