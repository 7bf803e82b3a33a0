// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "modules/exercises/palpation/operators/press.h"

#include <array>
#include <cstddef>

namespace chiron::operators {

/// A place where a palpator suspects something stiff, and how sure it is.
struct Suspicion {
    core::Vec2 place_m = core::Vec2::Zero();
    /// Share by which the tissue is stiffer than the background, in the middle of the suspected place.
    double amplitude = 0.0;
    double evidence = 0.0; ///< amplitude over its standard error
    double width_m = 0.0;  ///< felt width: H of models.md §3
};

/// Evaluates the presses of one trial for the presence of a lump at each place of a grid. It uses the
/// stiffness relative to the background (the median of all presses of the same pressure so far) and the lean,
/// which points away from a lump. For each place it fits one amplitude A by least squares: y = A g(ρ) and
/// lean = A ½ d |g′(ρ)| outwards, with g = (1 + ρ²/H²)⁻³ (models.md §3). Both are weighted with the noise
/// that the presses themselves show (median absolute deviation), so that only differences count. The work is
/// divided into a few places at a time. Fixed size; allocates nothing.
class EvidenceMap {
public:
    static constexpr std::size_t kMostPresses = 600;
    static constexpr int kSide = 33;
    static constexpr std::size_t kMostExplained = 8;
    static constexpr double kUsualWidth_m = 0.013; ///< of a lump, from experience: assumption
    /// There is no other lump nearer to a lump than this: assumption.
    static constexpr double kApart_m = 0.016;

    explicit EvidenceMap(const core::Vec2& half_m) noexcept : m_half_m(half_m) {}
    void clear() noexcept;
    void add(const Press& press) noexcept; ///< a press is dropped when the map is full
    std::size_t presses() const noexcept { return m_count; }

    /// Begins a new evaluation; what explained lumps account for stays left out.
    void begin() noexcept;
    /// Evaluates the next `places` of the grid; returns true when all are done.
    bool advance(int places) noexcept;
    /// Evidence for a lump exactly there, with the width that fits best.
    Suspicion at(const core::Vec2& place_m) const noexcept;
    /// The strongest suspicion; valid when all places are evaluated. Evidence 0: nothing was found.
    Suspicion strongest() const noexcept;
    /// Leaves out of the next evaluation what this lump accounts for.
    void explain(const Suspicion& lump) noexcept;
    /// No more lumps can be explained.
    bool explainedAll() const noexcept { return m_explainedCount == kMostExplained; }
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
    double medianOf(std::size_t n) noexcept; ///< of the first n values in m_scratch
    Weighed weigh(const core::Vec2& place_m, double width_m) const noexcept;
    core::Vec2 placeOf(int column, int row) const noexcept;
    bool nearExplained(const core::Vec2& place_m) const noexcept;

    core::Vec2 m_half_m;
    std::size_t m_count = 0;
    std::array<Press, kMostPresses> m_presses{};
    std::array<Residue, kMostPresses> m_residues{};
    std::array<double, kMostPresses> m_scratch{};
    double m_depth_m = 0.004; ///< median depth of the presses
    double m_ySd = 0.16;
    double m_leanSd_rad = 0.06;
    std::array<double, static_cast<std::size_t>(kSide) * kSide> m_evidence{};
    int m_weighed = 0;
    std::size_t m_explainedCount = 0;
    std::array<Suspicion, kMostExplained> m_explained{};
};

} // namespace chiron::operators
