// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/scene/tissue_look.h"

#include <algorithm>

namespace chiron::scene3d {

namespace {
constexpr double kBeside_m = 0.007;
constexpr double kAreola_m = 0.017;
} // namespace

TissueLook tissueLookOf(const simulation::TissueParameters& tissue) {
    const std::string first = tissue.layers.empty() ? std::string() : tissue.layers.front().name;
    if (first == "skin" || first == "fat") // fat is covered by skin
        return TissueLook::skin;
    return first == "silicone" || tissue.shape.bumps.empty() ? TissueLook::pad : TissueLook::gland;
}

Areola areolaOf(const simulation::TissueParameters& tissue) {
    if (tissueLookOf(tissue) != TissueLook::skin)
        return {};
    for (const simulation::StiffRegion& region : tissue.regions)
        if (region.name == "areola" || region.name == "nipple")
            return {region.centre_m, kAreola_m};
    const auto& bumps = tissue.shape.bumps;
    const auto highest = std::max_element(
        bumps.begin(), bumps.end(), [](const auto& a, const auto& b) { return a.height_m < b.height_m; });
    return highest == bumps.end() ? Areola{} : Areola{highest->centre_m, kAreola_m};
}

double palpationField_m(const simulation::PalpationParameters& parameters) {
    return parameters.areaHalf_m.norm() + kBeside_m;
}

} // namespace chiron::scene3d
