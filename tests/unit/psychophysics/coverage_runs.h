// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>
#include <vector>

// Whether intervals hold observers whom a design did not expect: three times as steep, as expected, three times as flat.
namespace coverage_runs {

/// One row of the table: a procedure or a design, and what is fitted to its answers.
struct Row {
    QString what;
    QString quantity;       ///< threshold, width or sigma
    double factor = 1.0;    ///< true width (σ) over what the design is made for
    int runs = 0;
    int covered = 0;        ///< 95 % intervals that hold the truth
    int warned = 0;         ///< runs with any warning
    int withoutInterval = 0;///< of which there is none: not covered
    int missedInSilence = 0;///< not covered, and no warning
    double influence = 0.0; ///< median over runs: how much the prior decided; not a number where there is no prior
};

/// All rows, `runs` each; answers are drawn from `seed`.
std::vector<Row> coverageTable(int runs, std::uint64_t seed);

/// Exact: whether 95 % lies in the 99.9 % interval (Clopper & Pearson) of what was covered, from below: more than 95 % is no fault.
bool notTooFew(const Row& row);

/// The fewest of so many runs that 95 % intervals hold by chance alone: the lower end of the exact 95 % interval of their number (184 of 200).
int fewestByChance(int runs);

void print(const std::vector<Row>& rows);

} // namespace coverage_runs
