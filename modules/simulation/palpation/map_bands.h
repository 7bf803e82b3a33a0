// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace chiron::simulation {

/// The steps in which every picture of a SurfaceMap shows its forces.
enum class MapBand : std::uint8_t {
    untouched,
    light,  ///< pressed, but too lightly to count as searched
    gentle, ///< searched, below the force band
    inBand,
    hard, ///< above the band
    over  ///< above the limit
};

/// Edges of the steps, N, ascending. PalpationParameters supplies the values.
struct MapBands {
    double cover_N = 0.5;
    double low_N = 0.8;
    double high_N = 2.5;
    double limit_N = 4.0;

    static constexpr double kTouched_N = 0.02; ///< the same threshold as for the time spent pressing

    constexpr MapBand of(double force_N) const noexcept {
        if (!(force_N > kTouched_N))
            return MapBand::untouched;
        if (force_N < cover_N)
            return MapBand::light;
        if (force_N < low_N)
            return MapBand::gentle;
        if (force_N <= high_N)
            return MapBand::inBand;
        return force_N <= limit_N ? MapBand::hard : MapBand::over;
    }
    bool operator==(const MapBands&) const = default;
};

/// Says whether a cell in this band counts as searched.
constexpr bool isSearched(MapBand band) noexcept {
    return band > MapBand::light;
}

} // namespace chiron::simulation
