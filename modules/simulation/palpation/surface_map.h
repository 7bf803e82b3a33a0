// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace chiron::simulation {

/// Records where a search area was pressed and how hard. The map is a grid over |x| ≤ half.x, |y| ≤ half.y
/// around the origin of W; each cell holds the largest normal force of all presses whose pad (radius a, as
/// seen from above) covered the cell's centre. The live coverage, the coverage score and the pictures of the
/// debrief all use this map. Fixed size.
/// Thread: a single one; allocates nothing.
class SurfaceMap {
public:
    static constexpr int kColumns = 48;
    static constexpr int kRows = 48;

    /// `half_m` > 0, `padRadius_m` = a > 0 (m). A cell that was pressed with at least `coverForce_N` counts
    /// as searched.
    SurfaceMap(const core::Vec2& half_m, double padRadius_m, double coverForce_N) noexcept;
    SurfaceMap() noexcept : SurfaceMap({0.04, 0.04}, 0.005, 0.5) {}

    void clear() noexcept;
    /// Records a press at (x, y) in W with this normal force (N). Of a press outside the area, only the part
    /// of the pad that reaches into it counts.
    void press(const core::Vec2& p_m, double normalForce_N) noexcept;

    double force_N(int column, int row) const noexcept { return m_force_N[index(column, row)]; }
    bool covered(int column, int row) const noexcept { return force_N(column, row) >= m_coverForce_N; }
    core::Vec2 middle_m(int column, int row) const noexcept; ///< centre of a cell, W
    const core::Vec2& half_m() const noexcept { return m_half_m; }
    double coverForce_N() const noexcept { return m_coverForce_N; }
    double coverage() const noexcept; ///< 0..1
    /// Increases whenever a cell changes, so that a view can tell whether it has drawn the newest state.
    std::uint32_t step() const noexcept { return m_step; }

private:
    static std::size_t index(int column, int row) noexcept {
        return static_cast<std::size_t>(row) * kColumns + static_cast<std::size_t>(column);
    }
    core::Vec2 m_half_m;
    double m_padRadius_m;
    double m_coverForce_N;
    int m_covered = 0;
    std::uint32_t m_step = 0;
    std::array<float, static_cast<std::size_t>(kColumns) * kRows> m_force_N{};
};

} // namespace chiron::simulation
