// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/designs/latin_square.h"

#include "core/random.h"
#include "psychophysics/designs/williams.h"

#include <numeric>
#include <string>
#include <utility>

namespace chiron::psychophysics {

namespace {

std::vector<int> shuffled(int n, core::Random random) {
    std::vector<int> items(static_cast<std::size_t>(n));
    std::iota(items.begin(), items.end(), 0);
    for (std::size_t i = items.size(); i > 1; --i)
        std::swap(items[i - 1], items[random.below(i)]);
    return items;
}

} // namespace

std::vector<std::vector<int>> latinSquare(int n, std::uint64_t seed) {
    std::vector<std::vector<int>> square;
    if (n < 1)
        return square;
    const std::vector<int> rows = shuffled(n, core::Random::stream(seed, "latin_square.rows"));
    const std::vector<int> places = shuffled(n, core::Random::stream(seed, "latin_square.places"));
    const std::vector<int> names = shuffled(n, core::Random::stream(seed, "latin_square.names"));
    for (const int row : rows) {
        square.emplace_back();
        for (const int place : places)
            square.back().push_back(names[static_cast<std::size_t>((row + place) % n)]);
    }
    return square;
}

std::vector<int> orderFor(OrderDesign design, int n, int row, std::uint64_t seed) {
    if (n < 1)
        return {};
    std::vector<std::vector<int>> rows;
    if (design == OrderDesign::williams)
        rows = williamsDesign(n);
    else if (design == OrderDesign::latinSquare)
        rows = latinSquare(n, seed);
    else if (design == OrderDesign::random)
        return shuffled(n, core::Random::stream(seed, "order." + std::to_string(row)));
    if (!rows.empty())
        return rows[static_cast<std::size_t>(row) % rows.size()];
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    return order;
}

} // namespace chiron::psychophysics
