// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/parts/skin_picture.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace chiron::scene3d {

namespace {

/// A small generator of its own: the picture is decoration, and must not draw from the streams of a session.
class Dice {
public:
    explicit Dice(std::uint32_t seed) : m_state(seed) {}
    float next() { // 0..1
        m_state = m_state * 1664525U + 1013904223U;
        return static_cast<float>(m_state >> 8) / 16777216.0F;
    }
    float around() { return 2.0F * next() - 1.0F; }

private:
    std::uint32_t m_state;
};

/// A plane of numbers that closes on itself in both directions.
class Sheet {
public:
    explicit Sheet(int side) : m_side(side), m_values(std::size_t(side) * std::size_t(side), 0.0F) {}
    int side() const { return m_side; }
    float& at(int x, int y) {
        const int mask = m_side - 1; // side is a power of two
        return m_values[std::size_t(y & mask) * std::size_t(m_side) + std::size_t(x & mask)];
    }

private:
    int m_side;
    std::vector<float> m_values;
};

/// From 0 to 1 with level ends.
float smooth(float t) {
    return t * t * (3.0F - 2.0F * t);
}

/// Smooth noise with `cells` cells a side, added with this weight.
void addNoise(Sheet& sheet, int cells, float weight, std::uint32_t seed) {
    Dice dice(seed);
    Sheet coarse(cells);
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x)
            coarse.at(x, y) = weight * dice.around();
    const int step = sheet.side() / cells;
    for (int y = 0; y < sheet.side(); ++y) {
        const float up = smooth(float(y % step) / float(step));
        float* row = &sheet.at(0, y);
        for (int cell = 0; cell < cells; ++cell) {
            const auto edge = [&](int x) {
                const float low = coarse.at(x, y / step);
                return low + up * (coarse.at(x, y / step + 1) - low);
            };
            const float left = edge(cell);
            const float rise = edge(cell + 1) - left;
            for (int x = 0; x < step; ++x)
                *row++ += left + rise * smooth(float(x) / float(step));
        }
    }
}

/// One soft round dab; the darker value stays.
void dab(Sheet& sheet, float x, float y, float radius, float strength) {
    const int reach = int(radius) + 2;
    for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx) {
            const float px = std::floor(x) + float(dx);
            const float py = std::floor(y) + float(dy);
            const float away = std::sqrt((px - x) * (px - x) + (py - y) * (py - y));
            const float value = strength * std::clamp((radius + 0.9F - away) / 1.8F, 0.0F, 1.0F);
            float& old = sheet.at(int(px) + 8 * sheet.side(), int(py) + 8 * sheet.side());
            old = std::max(old, value);
        }
    }
}

struct Vessel {
    float x, y, heading, radius, strength;
    int left; ///< steps
    int generation;
};

/// A vessel wanders, thins and sends off branches.
void grow(Sheet& sheet, Dice& dice, Vessel vessel) {
    float bend = 0.0F;
    const float thinning = vessel.radius * 0.55F / float(std::max(1, vessel.left));
    while (vessel.left-- > 0) {
        bend = 0.90F * bend + 0.010F * dice.around();
        vessel.heading += bend + 0.05F * dice.around();
        vessel.x += std::cos(vessel.heading);
        vessel.y += std::sin(vessel.heading);
        vessel.radius = std::max(0.25F, vessel.radius - thinning);
        dab(sheet, vessel.x, vessel.y, vessel.radius, vessel.strength);
        if (vessel.generation < 3 && dice.next() < 0.03F) {
            const float side = dice.next() < 0.5F ? -1.0F : 1.0F;
            grow(sheet, dice,
                 {vessel.x, vessel.y, vessel.heading + side * (0.5F + 0.5F * dice.next()),
                  vessel.radius * 0.66F, vessel.strength * 0.80F,
                  int(float(vessel.left) * (0.35F + 0.4F * dice.next())) + 12, vessel.generation + 1});
        }
    }
}

Sheet vessels(int side) {
    Sheet sheet(side);
    Dice dice(20261120U);
    const float unit = float(side) / 512.0F;
    for (int i = 0; i < 7; ++i)
        grow(sheet, dice,
             {dice.next() * float(side), dice.next() * float(side), dice.next() * 2.0F * float(core::kPi),
              (1.5F + 1.3F * dice.next()) * unit, 0.42F + 0.25F * dice.next(), int(420.0F * unit), 0});
    return sheet;
}

std::uint8_t byte(float value) {
    return static_cast<std::uint8_t>(std::clamp(value, 0.0F, 1.0F) * 255.0F + 0.5F);
}

} // namespace

std::vector<std::uint8_t> skinPicture(int side_px) {
    Sheet blood = vessels(side_px);
    Sheet mottle(side_px);
    addNoise(mottle, 8, 0.55F, 1U);
    addNoise(mottle, 16, 0.30F, 2U);
    addNoise(mottle, 64, 0.20F, 3U);
    Sheet film(side_px);
    addNoise(film, 8, 1.5F, 4U);
    addNoise(film, 16, 0.9F, 5U);
    addNoise(film, 64, 0.22F, 6U);
    std::vector<std::uint8_t> picture;
    picture.reserve(std::size_t(side_px) * std::size_t(side_px) * 4);
    const float steep = 1.0F * float(side_px) / 512.0F;
    for (int y = 0; y < side_px; ++y) {
        for (int x = 0; x < side_px; ++x) {
            const float height = film.at(x, y) - 0.6F * blood.at(x, y);
            const float right = film.at(x + 1, y) - 0.6F * blood.at(x + 1, y);
            const float up = film.at(x, y + 1) - 0.6F * blood.at(x, y + 1);
            picture.push_back(byte(0.5F + steep * (height - right)));
            picture.push_back(byte(0.5F + steep * (height - up)));
            picture.push_back(byte(blood.at(x, y)));
            picture.push_back(byte(0.5F + 0.5F * mottle.at(x, y)));
        }
    }
    return picture;
}

} // namespace chiron::scene3d
