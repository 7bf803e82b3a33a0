// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"

#include <cstdint>
#include <vector>

namespace chiron::scene3d {

/// A picture of mucosa, four bytes a pixel: slope of the wet surface across and along (128 = flat), blood in vessels,
/// mottling (0 = pale, 255 = red). Always the same one. Pure.
struct LiningPicture {
    int wide = 0;
    int high = 0;
    std::vector<std::uint8_t> bytes;
};

/// The urethra's wall: once round it across, kCanalTile_mm of it along; repeats in both directions. Vessels run along the
/// canal and branch; shallow folds lie along it.
LiningPicture canalPicture();
inline constexpr double kCanalTile_mm = 32.0;

/// The bladder's wall: azimuth across, polar angle from the dome (first row) to the neck. What the landmarks are is drawn
/// where they lie: an orifice of a ureter (id with "ureter") as a slit on a mound, with a ridge from one to the other and
/// the smooth trigone between them and the neck (drawn where two ureters are among the landmarks), a lesion ("lesion",
/// "tumour", "papill") as a raised red patch, a diverticulum ("divert") as a dark pit; every other one is a place of the
/// wall like those around it.
LiningPicture bladderPicture(const std::vector<simulation::BladderLandmark>& landmarks);

} // namespace chiron::scene3d
