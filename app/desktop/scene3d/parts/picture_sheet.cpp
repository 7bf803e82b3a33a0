// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/parts/picture_sheet.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

std::uint8_t pictureByte(float value) {
    return static_cast<std::uint8_t>(std::clamp(value, 0.0F, 1.0F) * 255.0F + 0.5F);
}

void addNoise(Sheet& sheet, int cellsAcross, int cellsUp, float weight, std::uint32_t seed) {
    Dice dice(seed);
    Sheet coarse(cellsAcross, cellsUp);
    for (int y = 0; y < cellsUp; ++y)
        for (int x = 0; x < cellsAcross; ++x)
            coarse.at(x, y) = weight * dice.around();
    const int stepX = sheet.wide() / cellsAcross;
    const int stepY = sheet.high() / cellsUp;
    for (int y = 0; y < sheet.high(); ++y) {
        const float up = smoothUp(float(y % stepY) / float(stepY));
        float* row = &sheet.at(0, y);
        for (int cell = 0; cell < cellsAcross; ++cell) {
            const auto edge = [&](int x) {
                const float low = coarse.at(x, y / stepY);
                return low + up * (coarse.at(x, y / stepY + 1) - low);
            };
            const float left = edge(cell);
            const float rise = edge(cell + 1) - left;
            for (int x = 0; x < stepX; ++x)
                *row++ += left + rise * smoothUp(float(x) / float(stepX));
        }
    }
}

void dab(Sheet& sheet, float x, float y, float radius, float strength) {
    const int reach = int(radius) + 2;
    for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx) {
            const float px = std::floor(x) + float(dx);
            const float py = std::floor(y) + float(dy);
            const float away = std::sqrt((px - x) * (px - x) + (py - y) * (py - y));
            const float value = strength * std::clamp((radius + 0.9F - away) / 1.8F, 0.0F, 1.0F);
            float& old = sheet.at(int(px) + 8 * sheet.wide(), int(py) + 8 * sheet.high());
            old = std::max(old, value);
        }
    }
}

void growVessel(Sheet& sheet, Dice& dice, Vessel vessel) {
    float bend = 0.0F;
    const float thinning = vessel.radius * 0.55F / float(std::max(1, vessel.left));
    while (vessel.left-- > 0) {
        bend = 0.90F * bend + 0.010F * dice.around();
        vessel.heading +=
            bend + 0.05F * dice.around() + vessel.keeping * std::sin(2.0F * (vessel.axis - vessel.heading));
        vessel.x += std::cos(vessel.heading);
        vessel.y += std::sin(vessel.heading);
        vessel.radius = std::max(0.25F, vessel.radius - thinning);
        dab(sheet, vessel.x, vessel.y, vessel.radius, vessel.strength);
        if (vessel.generation < 3 && dice.next() < 0.03F) {
            const float side = dice.next() < 0.5F ? -1.0F : 1.0F;
            growVessel(sheet, dice,
                       {vessel.x, vessel.y, vessel.heading + side * (0.5F + 0.5F * dice.next()),
                        vessel.radius * 0.66F, vessel.strength * 0.80F,
                        int(float(vessel.left) * (0.35F + 0.4F * dice.next())) + 12, vessel.generation + 1,
                        vessel.axis, vessel.keeping});
        }
    }
}

} // namespace chiron::scene3d
