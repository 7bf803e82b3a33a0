// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace chiron::scene3d {

/// A square picture of mucosa that repeats without a seam; four bytes a pixel: slope of the wet film in x and
/// y (128 = flat), blood in vessels, mottling. Always the same one. Pure; about 20 ms at 512 pixels.
std::vector<std::uint8_t> skinPicture(int side_px);

} // namespace chiron::scene3d
