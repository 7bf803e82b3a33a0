// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/blocked_sum.h"
#include "psychophysics/procedures/procedure.h"
#include "psychophysics/procedures/procedure_spec.h"

#include <cstddef>
#include <vector>

namespace chiron::psychophysics {

/// Probabilities over a product of parameter grids. The cells are ordered with the nuisance parameters
/// innermost and otherwise as given (the first outermost), and are padded with zeros to whole blocks. The
/// probabilities always sum to 1.
class PosteriorGrid {
public:
    /// Errors: badInput naming the key (empty grid, prior of another length, negative or all zero, values
    /// that are not finite).
    static core::Result<PosteriorGrid> make(const std::vector<ParameterGrid>& parameters);

    std::size_t parameters() const noexcept { return m_parameters.size(); }
    const ParameterGrid& parameter(std::size_t k) const noexcept { return m_parameters[k]; }
    std::size_t cells() const noexcept { return m_cells; }
    /// Number of neighbouring cells that differ only in nuisance parameters; 1 if there are none.
    std::size_t nuisanceCells() const noexcept { return m_nuisanceCells; }
    bool hasNuisance() const noexcept;
    std::size_t indexOf(std::size_t k, std::size_t cell) const noexcept {
        return cell / m_strides[k] % m_parameters[k].values.size();
    }
    double value(std::size_t k, std::size_t cell) const noexcept {
        return m_parameters[k].values[indexOf(k, cell)];
    }

    const std::vector<double>& probability() const noexcept { return m_probability; } ///< padded
    /// Blocks with a cell above 1e-17. All other blocks together change no entropy by 1e-11 (for grids below
    /// 10⁵ cells) and are skipped.
    const ActiveBlocks& active() const noexcept { return m_active; }

    /// Blocks that contain all of the probability except a share roughlyLeftOut() (at most 1e-7).
    const ActiveBlocks& roughlyActive() const noexcept { return m_roughlyActive; }
    double roughlyLeftOut() const noexcept { return m_roughlyLeftOut; }

    void restart(); ///< back to the prior
    /// Applies Bayes' rule with one likelihood per cell (padded). Returns false, and changes nothing, if the
    /// outcome is impossible in all cells.
    bool update(const std::vector<double>& likelihood);

    std::vector<double> marginal(std::size_t k) const;
    /// Returns posterior mean, sd and 95 % central interval (cells count as bars between the midpoints to
    /// their neighbours).
    NamedEstimate estimate(std::size_t k) const;
    double sd(std::size_t k) const;
    double entropy() const;   ///< nats, over the parameters that are not nuisance parameters
    std::size_t mode() const; ///< the most probable cell; the lowest of equally probable ones

private:
    void findActive();

    std::vector<ParameterGrid> m_parameters;
    std::vector<std::size_t> m_strides;
    std::size_t m_cells = 1;
    std::size_t m_nuisanceCells = 1;
    std::vector<double> m_prior;
    std::vector<double> m_probability;
    ActiveBlocks m_active;
    ActiveBlocks m_roughlyActive;
    double m_roughlyLeftOut = 0.0;
};

} // namespace chiron::psychophysics
