// SPDX-License-Identifier: GPL-3.0-or-later
// Set-up of the lumen's stations. It may allocate, so it is kept apart from the code of the tick.
#include "modules/exercises/urethra_insertion/simulation/lumen_sight.h"

#include <algorithm>
#include <cmath>

namespace chiron::simulation {

LumenSight::LumenSight(const UrethraInsertionParameters& parameters)
    : m_wall(parameters.anatomy, parameters.endoscope),
      m_cosHalfView(std::cos(0.5 * parameters.endoscope.fieldOfView_rad)) {
    const UrethraCentreline line(parameters.anatomy);
    const double bladder_m = parameters.anatomy.bladderRadius_m;
    const double end_m = line.length_m() + bladder_m;
    for (std::size_t i = 0; static_cast<double>(i) * kStep_m <= end_m; ++i) {
        const double s_m = static_cast<double>(i) * kStep_m;
        const double past_m = std::clamp(s_m - line.length_m(), 0.0, bladder_m);
        Station station{s_m, m_wall.radius_m(s_m), line.at(s_m).p_A};
        station.radius_m = std::max(station.radius_m, std::sqrt(past_m * (2.0 * bladder_m - past_m)));
        m_stations.push_back(station);
    }
}

} // namespace chiron::simulation
