// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"
#include "scoring/score_card.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace chiron::tests {

/// One session of a scripted operator, run, recorded and scored by the product.
struct LadderSession {
    std::uint64_t seed = 0;
    bool completed = false;
    scoring::ScoreCard card;
    std::uint64_t ticks = 0,
                  damped = 0; ///< damped: ticks in which the passivity controller took part of the force
    double kept_J = 0.0;      ///< what it kept from the hand in those ticks
    double tissue_N = 0.0, commanded_N = 0.0; ///< largest of any tool
    double fast_N = 0.0;                      ///< FastForce: the worst window's root mean square above 20 Hz
    double fastEnds_s = 0.0;                  ///< when that window ends
    bool checked = false;                     ///< replayed and scored again
    bool replaysIdentically = false, scoresIdentically = false;
};

struct LadderSettings {
    int seeds = 20;
    std::uint64_t first = 1;
    int checkEvery = 1;           ///< of the seeds, replayed and scored again; 0: none
    double budget_Ns_per_m = 0.0; ///< of damping, instead of what the devices say they carry; 0: theirs
};

/// All sessions of the operators novice, intermediate, expert and unsafe (as many of them as the exercise
/// has) on one level.
struct LadderLevel {
    std::string level;          ///< "exercise/number id"
    bool recordsEnergy = false; ///< it has laws that are not conservative
    std::map<std::string, std::vector<LadderSession>> byOperator;
};

LadderLevel climb(const catalogue::ExerciseLevel& level, const LadderSettings& settings);

/// A rate with its 95 % interval after Wilson.
struct Rate {
    int of = 0, n = 0;
    double share() const { return n > 0 ? static_cast<double>(of) / n : 0.0; }
    double low() const;
    double high() const;
};
Rate passRate(const std::vector<LadderSession>& sessions);
/// Lower end of the 95 % interval of how much higher `after` is than `before` (Newcombe 1998, hybrid score
/// interval of independent rates).
double riseAtLeast(const Rate& before, const Rate& after);

/// "metric: expert m ± s, unsafe m ± s" for each metric of safety or accuracy (all but speed, path and
/// smoothness) on which the unsafe hand is better with 95 % confidence (Welch), and for each gate that it
/// passes more often (Fisher's exact test, one-sided 2.5 %).
std::vector<std::string> inverted(const LadderLevel& level);

/// For people: one line per operator.
std::string heading();
std::string lines(const LadderLevel& level);
/// Mean and standard deviation of every metric, one line each, operators as columns; and where the hand was
/// shaken most.
std::string metricLines(const LadderLevel& level);

} // namespace chiron::tests
