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

/// How many nodes a pass has along each axis.
struct GridSize {
    std::size_t threshold, width, share, eta;
};

/// Log densities (over threshold, width, lapse, guess, η) at all nodes.
class DensityGrid {
public:
    DensityGrid(const PosteriorModel& model, PosteriorAxes axes);

    const PosteriorAxes& axes() const noexcept { return m_axes; }
    const std::vector<double>& logs() const noexcept { return m_logs; }
    double highest() const noexcept { return m_highest; }
    /// The largest log density over all other axes, a node each.
    std::vector<double> profile(std::size_t axis) const;
    CurveParameters parametersAt(std::size_t cell) const noexcept;
    std::size_t nodeOf(std::size_t cell, std::size_t axis) const noexcept { return cell / m_stride[axis] % m_axes.axis[axis].size(); }

private:
    void fill(const PosteriorModel& model);
    PosteriorAxes m_axes;
    std::array<std::size_t, PosteriorAxes::count> m_stride{};
    bool m_equal = false;
    std::vector<double> m_logs;
    double m_highest = 0.0;
};

/// The whole of what the priors allow.
PosteriorAxes wholeSpace(const PosteriorModel& model, const GridSize& size);
/// Axes around where the posterior lies (less than e^−14 of the largest density outside, `mode` inside), found by passes of a coarse grid.
PosteriorAxes posteriorRegion(const PosteriorModel& model, const DensityGrid& whole, const CurveParameters& mode,
                              const GridSize& fine);

} // namespace chiron::psychophysics
