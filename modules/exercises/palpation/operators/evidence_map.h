// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "modules/exercises/palpation/operators/press.h"

#include <array>
#include <cstddef>

namespace chiron::operators {

/// Where a palpator believes something stiff to be, and how sure it is.
struct Suspicion {
    core::Vec2 place_m = core::Vec2::Zero();
    double amplitude = 0.0; ///< stiffer than the background by this share, in its middle
    double evidence = 0.0;  ///< amplitude over its standard error
    double width_m = 0.0;   ///< how wide it feels: H of models.md §3
};

/// The presses of one trial, weighed against the expectation of a lump at each place of a grid: stiffness against the background
/// (the median of all presses of the same pressure so far), and lean, which points away from a lump. Least squares of one amplitude
/// a place, y = A g(ρ) and lean = A ½ d |g′(ρ)| outwards, g = (1 + ρ²/H²)⁻³ (models.md §3), each with the noise that the presses
/// themselves show (median absolute deviation), so that nothing but differences counts. Weighed a few places at a time. Fixed size;
/// nothing allocates.
class EvidenceMap {
public:
    static constexpr std::size_t kMostPresses = 600;
    static constexpr int kSide = 33;
    static constexpr std::size_t kMostExplained = 8;
    static constexpr double kUsualWidth_m = 0.013; ///< of a lump, from experience: assumption
    static constexpr double kApart_m = 0.016;      ///< nearer to one lump there is no other: assumption

    explicit EvidenceMap(const core::Vec2& half_m) noexcept : m_half_m(half_m) {}
    void clear() noexcept;
    void add(const Press& press) noexcept; ///< full: dropped
    std::size_t presses() const noexcept { return m_count; }

    void begin() noexcept;            ///< begins to weigh everything anew but what was explained
    bool advance(int places) noexcept; ///< by so many places of the grid; true when all are weighed
    Suspicion at(const core::Vec2& place_m) const noexcept; ///< what speaks for a lump just there, of the width that fits best
    Suspicion strongest() const noexcept; ///< when all are weighed; evidence 0: nothing
    void explain(const Suspicion& lump) noexcept; ///< what this lump accounts for is left out of the next weighing
    bool explainedAll() const noexcept { return m_explainedCount == kMostExplained; } ///< takes no more
    void forgetExplained() noexcept { m_explainedCount = 0; }

private:
    struct Weighed {
        double amplitude = 0.0;
        double evidence = 0.0;
    };
    struct Residue {
        double y = 0.0;
        core::Vec2 lean_rad = core::Vec2::Zero();
    };
    static constexpr int kPressures = 3;

    void settleBackground() noexcept;
    void leaveOutExplained() noexcept;
    void settleNoise() noexcept;
    double medianOf(std::size_t n) noexcept; ///< of the first n of m_scratch
    Weighed weigh(const core::Vec2& place_m, double width_m) const noexcept;
    core::Vec2 placeOf(int column, int row) const noexcept;
    bool nearExplained(const core::Vec2& place_m) const noexcept;

    core::Vec2 m_half_m;
    std::size_t m_count = 0;
    std::array<Press, kMostPresses> m_presses{};
    std::array<Residue, kMostPresses> m_residues{};
    std::array<double, kMostPresses> m_scratch{};
    double m_depth_m = 0.004; ///< usual depth of its presses
    double m_ySd = 0.16;
    double m_leanSd_rad = 0.06;
    std::array<double, static_cast<std::size_t>(kSide) * kSide> m_evidence{};
    int m_weighed = 0;
    std::size_t m_explainedCount = 0;
    std::array<Suspicion, kMostExplained> m_explained{};
};

} // namespace chiron::operators
