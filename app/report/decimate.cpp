// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/decimate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace chiron::report {

namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();

// The samples that are kept for one pixel column.
struct Column {
    std::size_t first = 0, low = 0, high = 0, last = 0;
    bool empty = true;

    void take(std::size_t i, std::span<const double> y) {
        if (empty) {
            first = low = high = last = i;
            empty = false;
            return;
        }
        low = y[i] < y[low] ? i : low;
        high = y[i] > y[high] ? i : high;
        last = i;
    }
    void flush(Polyline& out, std::span<const double> x, std::span<const double> y) {
        if (empty)
            return;
        std::array<std::size_t, 4> kept{first, low, high, last};
        std::sort(kept.begin(), kept.end());
        for (std::size_t k = 0; k < kept.size(); ++k) {
            if (k > 0 && kept[k] == kept[k - 1])
                continue;
            out.x.push_back(x[kept[k]]);
            out.y.push_back(y[kept[k]]);
        }
        empty = true;
    }
};

} // namespace

Polyline decimate(std::span<const double> x, std::span<const double> y, int columns) {
    const std::size_t count = std::min(x.size(), y.size());
    const std::size_t wanted = static_cast<std::size_t>(std::max(columns, 1));
    Polyline out;
    const double width = count > 0 ? x[count - 1] - x[0] : 0.0;
    if (count <= 4 * wanted || !(width > 0.0)) {
        out.x.assign(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(count));
        out.y.assign(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(count));
        return out;
    }
    Column column;
    double current = -1.0;
    bool inGap = false;
    for (std::size_t i = 0; i < count; ++i) {
        if (!std::isfinite(y[i]) || !std::isfinite(x[i])) {
            column.flush(out, x, y);
            if (!inGap && std::isfinite(x[i])) {
                out.x.push_back(x[i]);
                out.y.push_back(kGap);
                inGap = true;
            }
            continue;
        }
        inGap = false;
        const double here = std::floor((x[i] - x[0]) / width * static_cast<double>(wanted));
        if (here != current)
            column.flush(out, x, y);
        current = here;
        column.take(i, y);
    }
    column.flush(out, x, y);
    return out;
}

Polyline partAbove(const Polyline& line, double limit) {
    Polyline out;
    const std::size_t count = std::min(line.x.size(), line.y.size());
    for (std::size_t i = 0; i < count; ++i) {
        const double y = std::isfinite(line.y[i]) ? line.y[i] : limit;
        if (i > 0 && std::isfinite(line.y[i - 1]) && std::isfinite(line.y[i])) {
            const double before = line.y[i - 1] - limit;
            const double after = y - limit;
            if (before * after < 0.0) {
                out.x.push_back(line.x[i - 1] + (line.x[i] - line.x[i - 1]) * before / (before - after));
                out.y.push_back(limit);
            }
        }
        out.x.push_back(line.x[i]);
        out.y.push_back(std::max(y, limit));
    }
    return out;
}

} // namespace chiron::report
