// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/posterior_axes.h"
#include "psychophysics/fits/posterior_model.h"

namespace chiron::psychophysics {

/// The five axes of the posterior, outermost first. Widths are integrated over their logarithm.
struct PosteriorAxes {
    enum : std::size_t { threshold, logWidth, guess, lapse, eta, count };
    std::array<QuadratureAxis, count> axis;
    std::size_t cells() const noexcept;
};

/// How each axis is divided; `share` is for lapse and guess.
struct GridSize {
    AxisSize threshold, width, share, eta;
    const AxisSize& operator[](std::size_t axis) const noexcept;
};

/// Log densities (over threshold, width, lapse, guess, η) at all nodes.
class DensityGrid {
public:
    DensityGrid(const PosteriorModel& model, PosteriorAxes axes);

    const PosteriorAxes& axes() const noexcept { return m_axes; }
    const std::vector<double>& logs() const noexcept { return m_logs; }
    double highest() const noexcept { return m_highest; }
    CurveParameters parametersAt(std::size_t cell) const noexcept;
    std::size_t nodeOf(std::size_t cell, std::size_t axis) const noexcept {
        return cell / m_stride[axis] % m_axes.axis[axis].size();
    }

private:
    void fill(const PosteriorModel& model);
    PosteriorAxes m_axes;
    std::array<std::size_t, PosteriorAxes::count> m_stride{};
    bool m_equal = false;
    std::vector<double> m_logs;
    double m_highest = 0.0;
};

/// Mass of each cell, and marginal mass of each node of every axis, in units of e^reference.
struct Masses {
    std::vector<double> cell;
    std::array<std::vector<double>, PosteriorAxes::count> node;
    double total = 0.0;
};
Masses massesOf(const DensityGrid& grid, double reference);

/// Returns the axes of the whole space that the priors allow. Half of the threshold's nodes follow the
/// density of the levels.
PosteriorAxes wholeSpace(const PosteriorModel& model, const GridSize& size);

} // namespace chiron::psychophysics
