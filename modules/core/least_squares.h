// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace chiron::core {

/// Least squares of y on N regressors from running sums: fixed size, one pass. It solves the plain normal
/// equations with a tiny ridge term, so that a regressor that never moved gets no weight instead of an
/// infinite one.
/// Thread: any one; allocates nothing.
template <std::size_t N> class LeastSquares {
public:
    static constexpr int kFewest = 60; ///< smallest number of samples for a fit

    struct Fit {
        std::array<double, N> slope{};
        double residual = 0.0;                                     ///< residual sum of squares
        double firstSd = std::numeric_limits<double>::quiet_NaN(); ///< standard error of slope[0], with
                                                                   ///< residuals taken as independent
        int n = 0;
        bool good = false;
    };

    void reset() noexcept { *this = {}; }
    void add(const std::array<double, N>& x, double y) noexcept {
        for (std::size_t i = 0; i < N; ++i) {
            for (std::size_t j = 0; j < N; ++j)
                m_xx[i][j] += x[i] * x[j];
            m_xy[i] += x[i] * y;
        }
        m_yy += y * y;
        ++m_n;
    }
    int samples() const noexcept { return m_n; }

    /// Solves for the slopes and the first row of the inverse by Gauss–Jordan elimination with pivoting.
    /// `good` is false if there are too few samples or the regressors cannot be separated.
    Fit solve() const noexcept {
        Fit fit;
        fit.n = m_n;
        if (m_n < kFewest)
            return fit;
        std::array<std::array<double, N + 2>, N> a{};
        double scale = 0.0;
        for (std::size_t i = 0; i < N; ++i)
            scale = std::max(scale, m_xx[i][i]);
        for (std::size_t i = 0; i < N; ++i) {
            for (std::size_t j = 0; j < N; ++j)
                a[i][j] = m_xx[i][j];
            a[i][i] += 1e-13 * scale;
            a[i][N] = m_xy[i];
            a[i][N + 1] = i == 0 ? 1.0 : 0.0;
        }
        for (std::size_t column = 0; column < N; ++column) {
            std::size_t pivot = column;
            for (std::size_t row = column + 1; row < N; ++row)
                if (std::abs(a[row][column]) > std::abs(a[pivot][column]))
                    pivot = row;
            if (!(std::abs(a[pivot][column]) > 0.0))
                return fit;
            std::swap(a[pivot], a[column]);
            for (std::size_t row = 0; row < N; ++row) {
                const double share = row == column ? 0.0 : a[row][column] / a[column][column];
                for (std::size_t k = 0; share != 0.0 && k < N + 2; ++k)
                    a[row][k] -= share * a[column][k];
            }
        }
        fit.residual = m_yy;
        for (std::size_t i = 0; i < N; ++i) {
            fit.slope[i] = a[i][N] / a[i][i];
            fit.residual -= fit.slope[i] * m_xy[i];
        }
        fit.residual = std::max(0.0, fit.residual);
        const double variance = fit.residual / std::max(1, m_n - static_cast<int>(N));
        fit.firstSd = std::sqrt(std::max(0.0, variance * a[0][N + 1] / a[0][0]));
        fit.good = std::isfinite(fit.slope[0]);
        return fit;
    }

private:
    std::array<std::array<double, N>, N> m_xx{};
    std::array<double, N> m_xy{};
    double m_yy = 0.0;
    int m_n = 0;
};

} // namespace chiron::core
