// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>
#include <vector>

// Whether intervals hold observers whom a design did not expect: three times as steep, as expected, three
// times as flat.
namespace coverage_runs {

/// One row of the table: a procedure or a design, and what is fitted to its answers.
struct Row {
    QString what;
    QString quantity;    ///< threshold, width or sigma
    double factor = 1.0; ///< true width (σ) over what the design is made for
    int runs = 0;
    int covered = 0;         ///< 95 % intervals that hold the truth
    int warned = 0;          ///< runs with any warning
    int withoutInterval = 0; ///< of which there is none: not covered
    int missedInSilence = 0; ///< not covered, and no warning
    /// Median over runs: how much the prior decided; not a number where there is no prior.
    double influence = 0.0;
};

/// All rows, or those whose procedure has `only` in its name, `runs` each; answers are drawn from `seed`,
/// those of a row whatever others are asked for.
std::vector<Row> coverageTable(int runs, std::uint64_t seed, const QString& only = {});

/// The fewest of so many intervals that one row of a table of so many rows may hold, if each holds the truth
/// with a chance of 95 %: fewer has a chance below 5 % / rows in its row (exact binomial), so that a table of
/// true 95 % intervals fails at most one time in twenty (Bonferroni). More is no fault.
int fewestHeld(int runs, int rows);

void print(const std::vector<Row>& rows);

} // namespace coverage_runs
