// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/lining_picture.h"
#include "desktop/scene3d/parts/picture_sheet.h"

#include "core/units.h"

namespace chiron::scene3d {

namespace {

constexpr int kWide_px = 512;
constexpr int kHigh_px = 1024;

/// Most vessels run along the canal; every branch takes a direction of its own.
Sheet canalVessels() {
    Sheet sheet(kWide_px, kHigh_px);
    Dice dice(20261121U);
    constexpr float kAlong = 0.5F * float(core::kPi);
    for (int i = 0; i < 30; ++i) {
        const bool large = i < 6;
        const float heading = (dice.next() < 0.5F ? kAlong : -kAlong) + 0.3F * dice.around();
        growVessel(sheet, dice,
                   {dice.next() * float(kWide_px), dice.next() * float(kHigh_px), heading,
                    large ? 1.7F + 0.9F * dice.next() : 0.9F + 0.5F * dice.next(),
                    large ? 0.42F + 0.2F * dice.next() : 0.30F + 0.18F * dice.next(), large ? 560 : 330,
                    large ? 0 : 1, kAlong, 0.018F});
    }
    return sheet;
}

} // namespace

LiningPicture canalPicture() {
    Sheet blood = canalVessels();
    Sheet mottle(kWide_px, kHigh_px);
    addNoise(mottle, 4, 8, 0.50F, 11U);
    addNoise(mottle, 16, 16, 0.28F, 12U);
    addNoise(mottle, 64, 128, 0.16F, 13U);
    Sheet film(kWide_px, kHigh_px);
    addNoise(film, 16, 4, 2.6F, 14U); // folds along the canal
    addNoise(film, 32, 16, 1.0F, 15U);
    addNoise(film, 64, 128, 0.14F, 16U);
    addNoise(film, 256, 256, 0.03F, 17U);
    LiningPicture picture{kWide_px, kHigh_px, {}};
    picture.bytes.reserve(std::size_t(kWide_px) * kHigh_px * 4);
    for (int y = 0; y < kHigh_px; ++y) {
        for (int x = 0; x < kWide_px; ++x) {
            const auto height = [&](int px, int py) { return film.at(px, py) + 0.25F * blood.at(px, py); };
            picture.bytes.push_back(pictureByte(0.5F + 1.4F * (height(x - 1, y) - height(x + 1, y))));
            picture.bytes.push_back(pictureByte(0.5F + 1.4F * (height(x, y - 1) - height(x, y + 1))));
            picture.bytes.push_back(pictureByte(blood.at(x, y)));
            picture.bytes.push_back(pictureByte(0.5F + 0.5F * mottle.at(x, y)));
        }
    }
    return picture;
}

} // namespace chiron::scene3d
