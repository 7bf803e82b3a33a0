// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace chiron::bench {

/// One line of a benchmark's table. An absent number prints as "–"; an absent verdict as "not measured".
struct BenchRow {
    std::string work;
    std::string peer = "–";
    std::string unit = "ns";
    std::optional<double> peerMedian = std::nullopt;
    std::optional<double> oursMedian = std::nullopt;
    std::optional<double> p99 = std::nullopt;                ///< ours
    std::optional<double> p999 = std::nullopt;               ///< ours
    std::optional<std::uint64_t> allocations = std::nullopt; ///< ours, in all that was measured
    std::string agreement = "–";
    std::string goal = "–";
    std::string reached = "–";

    std::optional<double> ratio() const; ///< peer / ours
};

/// "yes" or "no"; "not measured" where there is nothing to judge.
std::string verdict(std::optional<bool> reached);
/// The value below which a share `fraction` (0..1) of the values lies (nearest rank); 0 if there are none.
double percentile(std::vector<double> values, double fraction);
/// printf to a string.
[[gnu::format(printf, 1, 2)]] std::string text(const char* format, ...);

/// Says what was measured on which machine: processors, load average, build.
void printHeading(const char* title);
/// A table that reads as plain text and as Markdown.
void printTable(const std::vector<BenchRow>& rows);

} // namespace chiron::bench
