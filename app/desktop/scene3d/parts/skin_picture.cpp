// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/parts/skin_picture.h"

#include "core/units.h"
#include "desktop/scene3d/parts/picture_sheet.h"

#include <cstddef>

namespace chiron::scene3d {

namespace {

Sheet vessels(int side) {
    Sheet sheet(side);
    Dice dice(20261120U);
    const float unit = float(side) / 512.0F;
    for (int i = 0; i < 7; ++i)
        growVessel(sheet, dice,
                   {dice.next() * float(side), dice.next() * float(side),
                    dice.next() * 2.0F * float(core::kPi), (1.5F + 1.3F * dice.next()) * unit,
                    0.42F + 0.25F * dice.next(), int(420.0F * unit), 0});
    return sheet;
}

} // namespace

std::vector<std::uint8_t> skinPicture(int side_px) {
    Sheet blood = vessels(side_px);
    Sheet mottle(side_px);
    addNoise(mottle, 8, 8, 0.55F, 1U);
    addNoise(mottle, 16, 16, 0.30F, 2U);
    addNoise(mottle, 64, 64, 0.20F, 3U);
    Sheet film(side_px);
    addNoise(film, 8, 8, 1.5F, 4U);
    addNoise(film, 16, 16, 0.9F, 5U);
    addNoise(film, 64, 64, 0.22F, 6U);
    std::vector<std::uint8_t> picture;
    picture.reserve(std::size_t(side_px) * std::size_t(side_px) * 4);
    const float steep = 1.0F * float(side_px) / 512.0F;
    for (int y = 0; y < side_px; ++y) {
        for (int x = 0; x < side_px; ++x) {
            const float height = film.at(x, y) - 0.6F * blood.at(x, y);
            const float right = film.at(x + 1, y) - 0.6F * blood.at(x + 1, y);
            const float up = film.at(x, y + 1) - 0.6F * blood.at(x, y + 1);
            picture.push_back(pictureByte(0.5F + steep * (height - right)));
            picture.push_back(pictureByte(0.5F + steep * (height - up)));
            picture.push_back(pictureByte(blood.at(x, y)));
            picture.push_back(pictureByte(0.5F + 0.5F * mottle.at(x, y)));
        }
    }
    return picture;
}

} // namespace chiron::scene3d
