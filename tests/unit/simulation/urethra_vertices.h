// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/urethra/urethra_surface.h"

#include <cmath>
#include <cstring>
#include <vector>

namespace chiron::tests {

using core::Vec3;
using simulation::UrethraSurface;

/// All planes and the arc lengths, one after the other.
inline std::vector<float> contents(const UrethraSurface& surface) {
    std::vector<float> all;
    for (int component = 0; component < 6; ++component)
        all.insert(all.end(), surface.plane(component).begin(), surface.plane(component).end());
    all.insert(all.end(), surface.arcLength_m().begin(), surface.arcLength_m().end());
    return all;
}

inline bool sameBits(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

inline Vec3 position(const UrethraSurface& surface, std::size_t v) {
    return {surface.plane(0)[v], surface.plane(1)[v], surface.plane(2)[v]};
}

inline Vec3 normalOf(const UrethraSurface& surface, std::size_t v) {
    return {surface.plane(3)[v], surface.plane(4)[v], surface.plane(5)[v]};
}

} // namespace chiron::tests
