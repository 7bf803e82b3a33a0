// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace chiron::operators {

/// Remembers what was felt and seen at each depth on the way in, as a guide for the way back. Depths are
/// those read from the shaft.
class WayMemory {
public:
    static constexpr double kFirst_m = -0.014;
    static constexpr double kCell_m = 0.004;
    static constexpr std::size_t kCells = 48;

    struct Place {
        bool kept = false;
        double pitch_rad = 0.0; ///< pitch of the instrument
        double lumen_rad = 0.0; ///< direction to where the lumen was seen
    };

    void keep(double depth_m, double pitch_rad, double lumen_rad) noexcept {
        Place& place =
            m_places[static_cast<std::size_t>(std::clamp((depth_m - kFirst_m) / kCell_m, 0.0, kLast))];
        const double share = place.kept ? kNew : 1.0;
        place.pitch_rad += share * (pitch_rad - place.pitch_rad);
        place.lumen_rad += share * (lumen_rad - place.lumen_rad);
        place.kept = true;
    }
    /// Interpolates between the two cells with the nearest centres; `kept` is false where nothing was stored.
    Place at(double depth_m) const noexcept {
        const double cell = std::clamp((depth_m - kFirst_m) / kCell_m - 0.5, 0.0, kLast);
        const auto low = static_cast<std::size_t>(cell);
        const Place& a = m_places[low];
        const Place& b = m_places[std::min(low + 1, kCells - 1)];
        if (!a.kept || !b.kept)
            return a.kept ? a : b;
        const double share = cell - static_cast<double>(low);
        return {true, a.pitch_rad + share * (b.pitch_rad - a.pitch_rad),
                a.lumen_rad + share * (b.lumen_rad - a.lumen_rad)};
    }

private:
    static constexpr double kNew = 0.05; ///< weight of an observation: assumption
    static constexpr double kLast = static_cast<double>(kCells - 1);
    std::array<Place, kCells> m_places{};
};

} // namespace chiron::operators
