// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/measures/dense_solve.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace chiron::psychophysics {

namespace {

constexpr double kGradientStep = 1e-5;
constexpr double kHessianStep = 1e-3;
constexpr int kMostSteps = 200;

using Function = std::function<double(const std::vector<double>&)>;

std::vector<double> gradientOf(const Function& f, std::vector<double> at) {
    std::vector<double> gradient(at.size());
    for (std::size_t i = 0; i < at.size(); ++i) {
        const double here = at[i];
        at[i] = here + kGradientStep;
        const double above = f(at);
        at[i] = here - kGradientStep;
        gradient[i] = (above - f(at)) / (2.0 * kGradientStep);
        at[i] = here;
    }
    return gradient;
}

Matrix informationOf(const Function& f, const std::vector<double>& at) { // the negative Hessian
    Matrix h(at.size(), std::vector<double>(at.size()));
    const auto moved = [&](std::size_t i, double a, std::size_t j, double b) {
        std::vector<double> point = at;
        point[i] += a;
        point[j] += b;
        return f(point);
    };
    for (std::size_t i = 0; i < at.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            const double s = kHessianStep;
            h[i][j] = h[j][i] =
                -(moved(i, s, j, s) - moved(i, s, j, -s) - moved(i, -s, j, s) + moved(i, -s, j, -s)) /
                (4.0 * s * s);
        }
    return h;
}

double sizeOf(const std::vector<double>& v) {
    double largest = 0.0;
    for (const double x : v)
        largest = std::max(largest, std::abs(x));
    return largest;
}

/// Takes one step uphill; returns its length, or 0 if no step rises.
double stepUp(const Function& f, Maximum& best) {
    const std::vector<double> gradient = gradientOf(f, best.at);
    const Matrix inverse = inverseOf(informationOf(f, best.at));
    std::vector<double> step = gradient;
    for (std::size_t i = 0; i < step.size() && !inverse.empty(); ++i) {
        step[i] = 0.0;
        for (std::size_t j = 0; j < step.size(); ++j)
            step[i] += inverse[i][j] * gradient[j];
    }
    const double longest = sizeOf(step);
    for (double share = std::min(1.0, 2.0 / std::max(longest, 1e-300)); share * longest > 1e-10;
         share *= 0.5) {
        std::vector<double> at = best.at;
        for (std::size_t i = 0; i < at.size(); ++i)
            at[i] += share * step[i];
        const double value = f(at);
        if (value >= best.value - 1e-13 * std::abs(best.value)) {
            best.at = std::move(at);
            best.value = value;
            return share * longest;
        }
    }
    return 0.0;
}

} // namespace

Matrix inverseOf(Matrix a) {
    const std::size_t n = a.size();
    Matrix inverse(n, std::vector<double>(n, 0.0));
    for (std::size_t i = 0; i < n; ++i)
        inverse[i][i] = 1.0;
    for (std::size_t column = 0; column < n; ++column) {
        std::size_t pivot = column;
        for (std::size_t row = column + 1; row < n; ++row)
            if (std::abs(a[row][column]) > std::abs(a[pivot][column]))
                pivot = row;
        if (!(std::abs(a[pivot][column]) > 1e-14))
            return {};
        std::swap(a[pivot], a[column]);
        std::swap(inverse[pivot], inverse[column]);
        const double scale = 1.0 / a[column][column];
        for (std::size_t k = 0; k < n; ++k) {
            a[column][k] *= scale;
            inverse[column][k] *= scale;
        }
        for (std::size_t row = 0; row < n; ++row) {
            const double factor = row == column ? 0.0 : a[row][column];
            for (std::size_t k = 0; k < n && factor != 0.0; ++k) {
                a[row][k] -= factor * a[column][k];
                inverse[row][k] -= factor * inverse[column][k];
            }
        }
    }
    return inverse;
}

Maximum maximise(const Function& f, std::vector<double> start) {
    Maximum best;
    best.at = std::move(start);
    best.value = f(best.at);
    if (!std::isfinite(best.value))
        return best;
    for (best.iterations = 0; best.iterations < kMostSteps && !best.found; ++best.iterations)
        best.found = stepUp(f, best) < 1e-9;
    best.covariance = inverseOf(informationOf(f, best.at));
    return best;
}

} // namespace chiron::psychophysics
