// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace chiron::core {

/// The program's own random number generator, so that a seed gives the same numbers for ever: xoshiro256++
/// 1.0 (Blackman & Vigna 2019, public domain algorithm) seeded by SplitMix64. It is named and versioned:
/// kName is stored with every use; tests/unit has test vectors.
class Random {
public:
    static constexpr std::string_view kName = "chiron-xoshiro256pp-1";

    explicit Random(std::uint64_t seed) noexcept;

    /// Returns an independent stream for one purpose: the seed is mixed with a name (FNV-1a, then
    /// SplitMix64). A name belongs to one source of random numbers: two that share a name and get the same
    /// seed draw the same numbers.
    static Random stream(std::uint64_t seed, std::string_view purpose) noexcept;
    static std::uint64_t mix(std::uint64_t seed, std::string_view purpose) noexcept;

    std::uint64_t next() noexcept;
    double uniform() noexcept; ///< [0, 1), 53 bits
    double uniform(double low, double high) noexcept { return low + (high - low) * uniform(); }
    std::uint64_t below(std::uint64_t bound) noexcept; ///< 0..bound-1, unbiased (Lemire 2019); bound > 0
    double normal() noexcept; ///< standard normal, Marsaglia's polar method, both values used

private:
    std::array<std::uint64_t, 4> m_state{};
    double m_spare = 0.0;
    bool m_hasSpare = false;
};

} // namespace chiron::core
