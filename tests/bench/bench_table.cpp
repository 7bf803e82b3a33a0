// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_table.h"

#include "core/fp_environment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <thread>

namespace chiron::bench {

namespace {
using Cells = std::array<std::string, 12>;

std::string number(std::optional<double> value) {
    if (!value)
        return "–";
    const double size = std::abs(*value);
    return text(size >= 1000.0               ? "%.0f"
                : size >= 10.0               ? "%.1f"
                : size >= 0.1 || size == 0.0 ? "%.2f"
                                             : "%.4f",
                *value);
}

Cells cellsOf(const BenchRow& row) {
    return {row.work,
            row.peer,
            row.unit,
            number(row.peerMedian),
            number(row.oursMedian),
            number(row.ratio()),
            number(row.p99),
            number(row.p999),
            row.allocations ? std::to_string(*row.allocations) : std::string("–"),
            row.agreement,
            row.goal,
            row.reached};
}

/// Columns on a screen, not bytes: continuation bytes of UTF-8 take none.
std::size_t widthOf(const std::string& cell) {
    return static_cast<std::size_t>(
        std::count_if(cell.begin(), cell.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

void printCells(const Cells& cells, const std::array<std::size_t, 12>& widths) {
    for (std::size_t i = 0; i < cells.size(); ++i)
        std::printf("| %s%*s ", cells[i].c_str(), static_cast<int>(widths[i] - widthOf(cells[i])), "");
    std::printf("|\n");
}
} // namespace

std::optional<double> BenchRow::ratio() const {
    if (!peerMedian || !oursMedian || *oursMedian <= 0.0)
        return std::nullopt;
    return *peerMedian / *oursMedian;
}

std::string verdict(std::optional<bool> reached) {
    return !reached ? "not measured" : *reached ? "yes" : "no";
}

double percentile(std::vector<double> values, double fraction) {
    if (values.empty())
        return 0.0;
    const auto last = static_cast<double>(values.size() - 1);
    const auto at = static_cast<std::ptrdiff_t>(std::ceil(std::clamp(fraction, 0.0, 1.0) * last));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

std::string text(const char* format, ...) {
    char buffer[512];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(buffer, sizeof buffer, format, arguments);
    va_end(arguments);
    return buffer;
}

void printHeading(const char* title) {
    double load[3] = {0.0, 0.0, 0.0};
    if (getloadavg(load, 3) != 3)
        load[0] = -1.0;
    std::printf("%s\n%s, %u processors, load average %.2f, build %s\n\n", title, core::cpuClass().c_str(),
                std::thread::hardware_concurrency(), load[0], core::buildId().c_str());
}

void printTable(const std::vector<BenchRow>& rows) {
    std::vector<Cells> lines{{"work", "peer", "unit", "peer median", "ours median", "ratio", "p99", "p99.9",
                              "allocations", "agreement", "goal", "reached"}};
    for (const BenchRow& row : rows)
        lines.push_back(cellsOf(row));
    std::array<std::size_t, 12> widths{};
    for (const Cells& line : lines)
        for (std::size_t i = 0; i < line.size(); ++i)
            widths[i] = std::max(widths[i], widthOf(line[i]));
    printCells(lines[0], widths);
    for (const std::size_t width : widths)
        std::printf("|%s", std::string(width + 2, '-').c_str());
    std::printf("|\n");
    for (std::size_t i = 1; i < lines.size(); ++i)
        printCells(lines[i], widths);
    std::printf("\n");
    std::fflush(stdout);
}

} // namespace chiron::bench
