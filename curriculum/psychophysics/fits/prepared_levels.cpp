// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/prepared_levels.h"

#include "core/log_gamma.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace chiron::psychophysics {
namespace {

struct Row {
    double axis, given, right, of;
};

bool wholeNumber(double value) noexcept {
    return value >= 0.0 && value < 9e15 && value == std::floor(value);
}

std::string countedRows(std::size_t count) {
    return std::to_string(count) + (count == 1 ? " row was" : " rows were");
}

/// Returns the usable rows by ascending position on the axis, and counts the others.
std::vector<Row> usableRows(const PsychometricData& data, StimulusScale scale, PreparedLevels& levels) {
    std::vector<Row> rows;
    const std::size_t complete = std::min({data.x.size(), data.k.size(), data.n.size()});
    std::size_t unusable = std::max({data.x.size(), data.k.size(), data.n.size()}) - complete;
    std::size_t offScale = 0;
    rows.reserve(complete);
    for (std::size_t i = 0; i < complete; ++i) {
        const double x = data.x[i], k = data.k[i], n = data.n[i];
        if (!isUsableRow(x, k, n)) {
            ++unusable;
        } else if (const double axis = toScale(x, scale); std::isnan(axis)) {
            ++offScale;
        } else if (n > 0.0) {
            rows.push_back({axis, x, k, n});
            levels.logCoefficients += logFactorial(n) - logFactorial(k) - logFactorial(n - k);
        }
    }
    if (unusable > 0) {
        levels.warnings.push_back("unusable_rows: " + countedRows(unusable) +
                                  " left out: a number is missing, infinite, negative or not whole, or more "
                                  "answers were right than given");
    }
    if (offScale > 0) {
        levels.warnings.push_back("off_scale: " + countedRows(offScale) +
                                  " left out: a negative intensity has no logarithm");
    }
    if (!std::is_sorted(rows.begin(), rows.end(),
                        [](const Row& a, const Row& b) { return a.axis < b.axis; })) {
        std::stable_sort(rows.begin(), rows.end(),
                         [](const Row& a, const Row& b) { return a.axis < b.axis; });
    }
    return rows;
}

/// Counts the distinct positions among sorted rows.
std::size_t differentPlaces(const std::vector<Row>& rows) noexcept {
    std::size_t count = rows.empty() ? 0 : 1;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        count += rows[i].axis != rows[i - 1].axis ? 1 : 0;
    }
    return count;
}

/// Merges the rows from `first` to before `last` at their mean position, weighted by answers.
Row together(const std::vector<Row>& rows, std::size_t first, std::size_t last, StimulusScale scale) {
    Row bin{0.0, 0.0, 0.0, 0.0};
    for (std::size_t i = first; i < last; ++i) {
        bin.right += rows[i].right;
        bin.of += rows[i].of;
    }
    for (std::size_t i = first; i < last; ++i) {
        bin.axis += rows[i].axis * (rows[i].of / bin.of);
    }
    bin.axis = std::clamp(bin.axis, rows[first].axis, rows[last - 1].axis);
    bin.given = rows[first].axis == rows[last - 1].axis ? rows[first].given : fromScale(bin.axis, scale);
    return bin;
}

/// If there are more than kMostFittedLevels positions (single trials at positions of their own), merges
/// neighbours into bins with about equal numbers of answers. Minus infinity stays separate.
std::vector<Row> binned(const std::vector<Row>& rows, StimulusScale scale,
                        std::vector<std::string>& warnings) {
    const std::size_t places = differentPlaces(rows);
    if (places <= kMostFittedLevels) {
        return rows;
    }
    const double answers = std::accumulate(rows.begin(), rows.end(), 0.0,
                                           [](double sum, const Row& row) { return sum + row.of; });
    const double each = answers / static_cast<double>(kMostFittedLevels);
    std::vector<Row> bins;
    double before = 0.0;
    for (std::size_t first = 0; first < rows.size();) {
        const double until = each * (std::floor(before / each + 0.5) + 1.0);
        std::size_t last = first;
        do {
            before += rows[last++].of;
        } while (last < rows.size() && std::isfinite(rows[first].axis) == std::isfinite(rows[last].axis) &&
                 (rows[last].axis == rows[last - 1].axis || before + 0.5 * rows[last].of <= until));
        bins.push_back(together(rows, first, last, scale));
        first = last;
    }
    warnings.push_back("binned: answers at " + std::to_string(places) +
                       " intensities were put together into " + std::to_string(bins.size()) +
                       " of about equal numbers");
    return bins;
}

double finiteRange(const std::vector<Row>& rows, double& centre) noexcept {
    const auto first =
        std::find_if(rows.begin(), rows.end(), [](const Row& row) { return std::isfinite(row.axis); });
    if (first == rows.end()) {
        return 0.0;
    }
    const double low = first->axis, high = rows.back().axis;
    centre = low + 0.5 * (high - low);
    const double range = high - low;
    const double rounding =
        8.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(low), std::abs(high));
    return std::isfinite(range) && range > rounding ? range : 0.0;
}

void append(PreparedLevels& levels, const Row& row) {
    levels.axis.push_back(row.axis);
    levels.given.push_back(row.given);
    levels.right.push_back(row.right);
    levels.of.push_back(row.of);
}

void mergeRows(const std::vector<Row>& rows, PreparedLevels& levels) {
    const double largest =
        rows.empty() ? 0.0
                     : std::max(std::isfinite(rows.front().axis) ? std::abs(rows.front().axis) : 0.0,
                                std::abs(rows.back().axis));
    const double same = std::max(1e-9 * levels.range, 8.0 * std::numeric_limits<double>::epsilon() * largest);
    for (const Row& row : rows) {
        levels.totalRight += row.right;
        levels.total += row.of;
        const bool repeated =
            !levels.axis.empty() && (row.axis == levels.axis.back() || row.axis - levels.axis.back() <= same);
        if (repeated) {
            levels.right.back() += row.right;
            levels.of.back() += row.of;
        } else {
            append(levels, row);
        }
    }
}

void measureSpacing(PreparedLevels& levels) {
    levels.spacing = levels.range;
    levels.unit.resize(levels.size());
    for (std::size_t i = 0; i < levels.size(); ++i) {
        levels.unit[i] = (levels.axis[i] - levels.centre) / levels.range;
        if (i > 0 && std::isfinite(levels.axis[i - 1])) {
            levels.spacing = std::min(levels.spacing, levels.axis[i] - levels.axis[i - 1]);
        }
    }
}

} // namespace

double logFactorial(double n) noexcept {
    static const auto table = [] {
        std::array<double, 256> values{};
        for (std::size_t i = 1; i < values.size(); ++i) {
            values[i] = core::logGamma(static_cast<double>(i) + 1.0);
        }
        return values;
    }();
    if (n < 256.0) {
        return table[static_cast<std::size_t>(n)];
    }
    const double inverse = 1.0 / n;
    const double series =
        inverse * (1.0 / 12.0 - inverse * inverse * (1.0 / 360.0 - inverse * inverse / 1260.0));
    return (n + 0.5) * std::log(n) - n + 0.5 * std::log(2.0 * std::numbers::pi) + series;
}

bool isUsableRow(double x, double right, double of) noexcept {
    return std::isfinite(x) && wholeNumber(right) && wholeNumber(of) && right <= of;
}

PreparedLevels prepareLevels(const PsychometricData& data, StimulusScale scale) {
    PreparedLevels levels;
    const std::vector<Row> rows = binned(usableRows(data, scale, levels), scale, levels.warnings);
    levels.range = finiteRange(rows, levels.centre);
    for (auto* column : {&levels.axis, &levels.given, &levels.right, &levels.of}) {
        column->reserve(std::min<std::size_t>(rows.size(), 64));
    }
    mergeRows(rows, levels);
    if (levels.usable()) {
        measureSpacing(levels);
    } else if (rows.empty()) {
        levels.warnings.push_back("no_data: there is no usable answer, so nothing was fitted");
    } else {
        levels.warnings.push_back(
            "one_level: all answers were given at one intensity; a curve needs at least two");
    }
    return levels;
}

} // namespace chiron::psychophysics
