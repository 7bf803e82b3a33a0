// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"

#include <cstdint>
#include <vector>

namespace chiron::scene3d {

/// A picture of mucosa, four bytes per pixel: slope of the wet surface across and along (128 = flat), blood
/// in vessels, mottling (0 = pale, 255 = red). The result is always the same. Pure.
struct LiningPicture {
    int wide = 0;
    int high = 0;
    std::vector<std::uint8_t> bytes;
};

/// The urethra's wall: its width is one turn, its height kCanalTile_mm along the canal; it repeats in both
/// directions. Vessels run along the canal and branch; shallow folds lie along it.
LiningPicture canalPicture();
inline constexpr double kCanalTile_mm = 32.0;

/// The bladder's wall: azimuth across, polar angle from the dome (first row) to the neck. Each landmark is
/// drawn at its position by its type: an orifice of a ureter (id with "ureter") as a slit on a mound, a
/// lesion ("lesion", "tumour", "papill") as a raised red patch, a diverticulum ("divert") as a dark pit; any
/// other landmark looks like the wall around it. If there are two ureters, a ridge joins their orifices, with
/// the smooth trigone between them and the neck.
LiningPicture bladderPicture(const std::vector<simulation::BladderLandmark>& landmarks);

} // namespace chiron::scene3d
