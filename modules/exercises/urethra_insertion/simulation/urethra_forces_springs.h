// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <array>

namespace chiron::simulation {

/// Sums over the compressed springs of a section, with c_j = ê·u_j; s_j is the same along ê turned by +90°.
struct SpringSums {
    double count = 16.0; ///< Σ 1
    double c = 0.0, c2 = 8.0, c3 = 0.0;
    double s = 0.0, sc = 0.0, sc2 = 0.0;
};

/// The 16 radial springs of a section (models.md §1.2). Their compressions are Δ_j = max(0, A + b c_j) with
/// the same direction ê of the tip's offset in every section. Which springs are compressed depends only on
/// A/b: they are the first m in the order of falling c_j, an arc around ê, and the sums of c_j, c_j², c_j³ …
/// over an arc are trigonometric sums with tabulated coefficients. A section therefore costs the same whether
/// its springs are slack or not, and the result equals the plain sum over j. Spring j stands at jπ/8 from x̂
/// towards n. Pure.
/// Thread: haptic.
class RadialSprings {
public:
    static constexpr int kCount = 16;

    /// `ex_m`, `en_m`: the offset e of the tip along x̂ and along n, m.
    RadialSprings(double ex_m, double en_m) noexcept;

    double offset_m() const noexcept { return m_offset_m; } ///< |e|
    /// Sums over the springs with A + b c_j > 0, b ≥ 0. Few steps are needed per section if sections are
    /// queried in order along the canal.
    const SpringSums& compressed(double A_m, double b_m) noexcept {
        if (!m_ordered)
            order();
        int m = m_compressed;
        while (m < kCount && A_m + b_m * m_c[static_cast<std::size_t>(m)] > 0.0)
            ++m;
        while (m > 0 && !(A_m + b_m * m_c[static_cast<std::size_t>(m - 1)] > 0.0))
            --m;
        if (m != m_compressed)
            sum(m);
        return m_sums;
    }
    /// Converts a vector that is given along ê and along ê turned by +90° to (x̂, n).
    core::Vec2 inSection(double along, double across) const noexcept;

private:
    void order() noexcept; ///< prepares values that only a section with slack springs needs
    void sum(int compressed) noexcept;

    double m_offset_m;
    double m_ex = 1.0, m_en = 0.0;   ///< ê
    double m_cos = 1.0, m_sin = 0.0; ///< ê mirrored into the wedge 0 … π/16 from a spring
    double m_turn = 1.0;             ///< −1 where that took an odd number of reflections
    bool m_ordered = false;
    int m_compressed = kCount;
    std::array<double, kCount> m_c{}; ///< c_j in falling order
    SpringSums m_sums;
};

} // namespace chiron::simulation
