// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace chiron::scene3d {

/// A small random number generator of its own. Pictures are decoration and must not draw numbers from the
/// random streams of a session.
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

/// A grid of numbers that is periodic in both directions. Both sides are powers of two.
class Sheet {
public:
    Sheet(int wide, int high)
        : m_wide(wide), m_high(high), m_values(std::size_t(wide) * std::size_t(high), 0.0F) {}
    explicit Sheet(int side) : Sheet(side, side) {}
    int wide() const { return m_wide; }
    int high() const { return m_high; }
    float& at(int x, int y) {
        return m_values[std::size_t(y & (m_high - 1)) * std::size_t(m_wide) + std::size_t(x & (m_wide - 1))];
    }

private:
    int m_wide;
    int m_high;
    std::vector<float> m_values;
};

/// Smoothstep: rises from 0 to 1 with zero slope at both ends.
inline float smoothUp(float t) {
    return t * t * (3.0F - 2.0F * t);
}

/// Converts 0..1 to a byte of a picture.
std::uint8_t pictureByte(float value);

/// Adds smooth noise with this weight and this many cells along each side (powers of two).
void addNoise(Sheet& sheet, int cellsAcross, int cellsUp, float weight, std::uint32_t seed);

/// Draws one soft round spot. Where spots overlap, the darker value remains.
void dab(Sheet& sheet, float x, float y, float radius, float strength);

/// A blood vessel, which meanders, becomes thinner and branches. Lengths are in pixels.
struct Vessel {
    float x, y, heading, radius, strength;
    int left; ///< remaining steps
    int generation;
    float axis = 0.0F;    ///< preferred heading, in either direction along it
    float keeping = 0.0F; ///< how strongly it keeps to `axis`; 0: not at all
};
void growVessel(Sheet& sheet, Dice& dice, Vessel vessel);

} // namespace chiron::scene3d
