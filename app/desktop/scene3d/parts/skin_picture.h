// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace chiron::scene3d {

/// A square, seamlessly repeating picture of mucosa with four bytes per pixel: slope of the wet film in x and
/// y (128 = flat), blood in vessels, mottling. It is always the same picture. Pure; takes about 20 ms at 512
/// pixels.
std::vector<std::uint8_t> skinPicture(int side_px);

} // namespace chiron::scene3d
