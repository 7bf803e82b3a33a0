// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/lining_picture.h"
#include "core/geometry.h"
#include "core/units.h"
#include "desktop/scene3d/parts/picture_sheet.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

constexpr int kWide_px = 1024;
constexpr int kHigh_px = 512;
constexpr float kPi = float(core::kPi);

using Direction = Eigen::Vector3f; ///< x: x̂, y: n, z: t(C), of the unit sphere

Direction directionOf(float polar, float azimuth) {
    return {std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar)};
}

/// The sphere's wall, unrolled. Every painting function below measures on the sphere, so that nothing is
/// distorted at the poles.
class Unrolled {
public:
    Unrolled() : m_values(std::size_t(kWide_px) * kHigh_px, 0.0F) {}
    float& at(int x, int y) {
        return m_values[std::size_t(std::clamp(y, 0, kHigh_px - 1)) * kWide_px +
                        std::size_t(x & (kWide_px - 1))];
    }
    static Direction direction(int x, int y) {
        return directionOf((float(y) + 0.5F) / kHigh_px * kPi, (float(x) + 0.5F) / kWide_px * 2.0F * kPi);
    }

    /// Calls paint(value, angle) for every pixel within `reach` radians of this direction.
    template <class Paint> void around(const Direction& middle, float reach, Paint paint) {
        const float polar = std::acos(std::clamp(middle.z(), -1.0F, 1.0F));
        const int top = std::max(0, int((polar - reach) / kPi * kHigh_px) - 1);
        const int bottom = std::min(kHigh_px - 1, int((polar + reach) / kPi * kHigh_px) + 1);
        const float sine =
            std::min(std::sin(std::max(0.0F, polar - reach)), std::sin(std::min(kPi, polar + reach)));
        const bool all = polar - reach <= 0.02F || polar + reach >= kPi - 0.02F;
        const int half =
            all ? kWide_px / 2
                : std::min(kWide_px / 2,
                           int(1.3F * reach / std::max(0.02F, sine) / (2.0F * kPi) * kWide_px) + 2);
        const int centre = int(std::atan2(middle.y(), middle.x()) / (2.0F * kPi) * kWide_px);
        for (int y = top; y <= bottom; ++y)
            for (int x = centre - half; x < centre + half; ++x) {
                const Direction d = direction(x & (kWide_px - 1), y);
                const float chord = (d - middle).norm();
                if (chord < reach)
                    paint(at(x, y), chord, d);
            }
    }

private:
    std::vector<float> m_values;
};

/// A vessel on the sphere; lengths in radians.
struct SphereVessel {
    Direction at;
    Direction ahead; ///< unit, tangent
    float radius;
    float strength;
    int left;
    int generation;
};

constexpr float kStep = 0.0075F;

void grow(Unrolled& blood, Dice& dice, SphereVessel v) {
    float bend = 0.0F;
    const float thinning = v.radius * 0.6F / float(std::max(1, v.left));
    while (v.left-- > 0) {
        bend = 0.9F * bend + 0.022F * dice.around();
        const Direction beside = v.at.cross(v.ahead);
        v.ahead = (v.ahead + (bend + 0.07F * dice.around()) * beside).normalized();
        v.at = (v.at + kStep * v.ahead).normalized();
        v.ahead = (v.ahead - v.ahead.dot(v.at) * v.at).normalized();
        v.radius = std::max(0.0028F, v.radius - thinning);
        const float soft = 0.004F;
        blood.around(v.at, v.radius + soft, [&](float& value, float away, const Direction&) {
            value = std::max(value,
                             v.strength * std::clamp((v.radius + soft - away) / (2.0F * soft), 0.0F, 1.0F));
        });
        if (v.generation < 3 && dice.next() < 0.05F) {
            const float side = (dice.next() < 0.5F ? -1.0F : 1.0F) * (0.5F + 0.6F * dice.next());
            const Direction turned = (v.ahead + side * v.at.cross(v.ahead)).normalized();
            grow(blood, dice,
                 {v.at, turned, v.radius * 0.68F, v.strength * 0.82F,
                  int(float(v.left) * (0.3F + 0.4F * dice.next())) + 8, v.generation + 1});
        }
    }
}

float hashed(int x, int y, int z, std::uint32_t seed) {
    std::uint32_t h = std::uint32_t(x) * 374761393U + std::uint32_t(y) * 668265263U +
                      std::uint32_t(z) * 2246822519U + seed * 3266489917U;
    h = (h ^ (h >> 13)) * 1274126177U;
    h ^= h >> 16;
    return float(h & 0xFFFFU) / 32767.5F - 1.0F;
}

/// Smooth noise in space, −1..1.
float noise(const Direction& p, float cells, std::uint32_t seed) {
    const Direction q = p * cells + Direction::Constant(64.0F);
    const int x = int(q.x()), y = int(q.y()), z = int(q.z());
    const float u = smoothUp(q.x() - float(x)), v = smoothUp(q.y() - float(y)),
                w = smoothUp(q.z() - float(z));
    const auto along = [&](int dy, int dz) {
        const float a = hashed(x, y + dy, z + dz, seed);
        return a + u * (hashed(x + 1, y + dy, z + dz, seed) - a);
    };
    const float low = along(0, 0) + v * (along(1, 0) - along(0, 0));
    const float high = along(0, 1) + v * (along(1, 1) - along(0, 1));
    return low + w * (high - low);
}

struct Sheets {
    Unrolled blood;
    Unrolled red;    ///< 0..1 mottling
    Unrolled height; ///< of the surface, radians
};

bool named(const simulation::BladderLandmark& landmark, const char* part) {
    return landmark.id.find(part) != std::string::npos;
}

Direction placeOf(const simulation::BladderLandmark& landmark) {
    return directionOf(float(landmark.polar_rad), float(landmark.azimuth_rad));
}

void paintWall(Sheets& sheets) {
    Dice dice(20261122U);
    for (int i = 0; i < 46; ++i) {
        const float up = dice.around();
        const float turn = dice.next() * 2.0F * kPi;
        const Direction at = directionOf(std::acos(up), turn);
        const Direction aside =
            (at.cross(Direction(dice.around(), dice.around(), dice.around()))).normalized();
        grow(sheets.blood, dice,
             {at, aside, 0.0055F + 0.0060F * dice.next(), 0.35F + 0.35F * dice.next(),
              70 + int(60.0F * dice.next()), 0});
    }
    for (int y = 0; y < kHigh_px; ++y)
        for (int x = 0; x < kWide_px; ++x) {
            const Direction d = Unrolled::direction(x, y);
            sheets.red.at(x, y) =
                0.46F + 0.22F * noise(d, 3.0F, 1U) + 0.12F * noise(d, 9.0F, 2U) + 0.06F * noise(d, 40.0F, 3U);
            sheets.height.at(x, y) = 0.030F * noise(d, 4.0F, 4U) + 0.010F * noise(d, 14.0F, 5U) +
                                     0.0012F * noise(d, 60.0F, 6U) + 0.0025F * sheets.blood.at(x, y);
        }
}

/// Paints the smooth triangle between two ureters and the neck, with the ridge between the ureters.
void paintTrigone(Sheets& sheets, const Direction& one, const Direction& other) {
    const Direction neck(0.0F, 0.0F, -1.0F);
    const Direction corners[3] = {one, other, neck};
    for (int y = 0; y < kHigh_px; ++y)
        for (int x = 0; x < kWide_px; ++x) {
            const Direction d = Unrolled::direction(x, y);
            float inside = 1.0F;
            const float turn = one.cross(other).dot(neck) > 0.0F ? 1.0F : -1.0F;
            for (int k = 0; k < 3; ++k)
                inside = std::min(inside, turn * corners[k].cross(corners[(k + 1) % 3]).normalized().dot(d));
            const float in = std::clamp(inside / 0.10F + 0.7F, 0.0F, 1.0F);
            sheets.height.at(x, y) *= 1.0F - 0.75F * in;
            sheets.red.at(x, y) += 0.20F * in;
            const float edge = one.cross(other).normalized().dot(d);
            const bool between =
                d.dot((one + other).normalized()) > one.dot((one + other).normalized()) - 0.03F;
            if (between && std::abs(edge) < 0.10F)
                sheets.height.at(x, y) += 0.022F * std::exp(-edge * edge / (2.0F * 0.022F * 0.022F));
        }
}

/// Paints a slit on a mound, along the ridge.
void paintOrifice(Sheets& sheets, const Direction& at, const Direction& along) {
    const Direction tangent = (along - along.dot(at) * at).normalized();
    const Direction beside = at.cross(tangent);
    sheets.height.around(at, 0.20F, [&](float& value, float away, const Direction& d) {
        value += 0.030F * std::exp(-away * away / (2.0F * 0.055F * 0.055F));
        const float u = (d - at).dot(tangent) / 0.060F;
        const float v = ((d - at).dot(beside) - 0.010F * u * u) / 0.016F;
        value -= 0.034F * std::exp(-0.5F * (u * u + v * v));
    });
    sheets.blood.around(at, 0.16F, [&](float& value, float, const Direction& d) {
        const float u = (d - at).dot(tangent) / 0.052F;
        const float v = ((d - at).dot(beside) - 0.010F * u * u) / 0.010F;
        value = std::max(value, 1.0F * std::exp(-0.5F * (u * u * u * u + v * v)));
    });
}

void paintPatch(Sheets& sheets, const Direction& at, float height, float blood) {
    sheets.height.around(at, 0.22F, [&](float& value, float away, const Direction& d) {
        const float bump = std::exp(-away * away / (2.0F * 0.06F * 0.06F));
        value += height * bump * (1.0F + 0.5F * noise(d, 45.0F, 9U));
    });
    sheets.blood.around(at, 0.16F, [&](float& value, float away, const Direction&) {
        value = std::max(value, blood * std::exp(-away * away / (2.0F * 0.05F * 0.05F)));
    });
}

void paintLandmarks(Sheets& sheets, const std::vector<simulation::BladderLandmark>& landmarks) {
    std::vector<Direction> ureters;
    for (const auto& landmark : landmarks)
        if (named(landmark, "ureter"))
            ureters.push_back(placeOf(landmark));
    if (ureters.size() == 2)
        paintTrigone(sheets, ureters[0], ureters[1]);
    for (std::size_t i = 0; i < ureters.size(); ++i)
        paintOrifice(sheets, ureters[i],
                     ureters.size() == 2 ? Direction(ureters[1 - i] - ureters[i])
                                         : Direction(ureters[i].cross(Direction(0, 0, 1))));
    for (const auto& landmark : landmarks) {
        if (named(landmark, "lesion") || named(landmark, "tumour") || named(landmark, "papill"))
            paintPatch(sheets, placeOf(landmark), 0.05F, 0.45F);
        if (named(landmark, "divert"))
            paintPatch(sheets, placeOf(landmark), -0.07F, 0.95F);
    }
}

} // namespace

LiningPicture bladderPicture(const std::vector<simulation::BladderLandmark>& landmarks) {
    Sheets sheets;
    paintWall(sheets);
    paintLandmarks(sheets, landmarks);
    LiningPicture picture{kWide_px, kHigh_px, {}};
    picture.bytes.reserve(std::size_t(kWide_px) * kHigh_px * 4);
    for (int y = 0; y < kHigh_px; ++y) {
        const float down = 2.0F * kPi / kHigh_px; // spacing of two rows
        const float round =
            std::max(0.02F, std::sin((float(y) + 0.5F) / kHigh_px * kPi)) * 4.0F * kPi / kWide_px;
        for (int x = 0; x < kWide_px; ++x) {
            const float across = (sheets.height.at(x - 1, y) - sheets.height.at(x + 1, y)) / round;
            const float along = (sheets.height.at(x, y - 1) - sheets.height.at(x, y + 1)) / down;
            picture.bytes.push_back(pictureByte(0.5F + 0.5F * across));
            picture.bytes.push_back(pictureByte(0.5F + 0.5F * along));
            picture.bytes.push_back(pictureByte(sheets.blood.at(x, y)));
            picture.bytes.push_back(pictureByte(sheets.red.at(x, y)));
        }
    }
    return picture;
}

} // namespace chiron::scene3d
