// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"
#include "scoring/score_card.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace chiron::tests {

class LadderStore;

/// One session of a scripted operator, run, recorded and scored by the product.
struct LadderSession {
    std::uint64_t seed = 0;
    bool completed = false;
    scoring::ScoreCard card;
    std::uint64_t ticks = 0;
    std::uint64_t acted = 0;   ///< ticks in which the passivity controller damped, or rendered a body softer
    double kept_J = 0.0;       ///< PassivityController::kept_J(): withheld, less what was spared
    double withheld_J = 0.0;   ///< PassivityController::withheld_J(): never negative
    double heldBeyond_J = 0.0; ///< the most that the touched bodies held beyond the work put into them
    double tissue_N = 0.0, commanded_N = 0.0; ///< largest of any tool
    double fast_N = 0.0;                      ///< FastForce: the worst window's root mean square above 20 Hz
    double fastEnds_s = 0.0;                  ///< when that window ends
    std::uint64_t windows = 0;                ///< that FastForce had
    bool checked = false;                     ///< replayed and scored again
    bool replaysIdentically = false, scoresIdentically = false;
};

struct LadderSettings {
    int seeds = 20;
    std::uint64_t first = 1;
    int checkEvery = 1;           ///< of the seeds, replayed and scored again; 0: none
    double budget_Ns_per_m = 0.0; ///< of damping, instead of what the devices say they carry; 0: theirs
    std::string hand;             ///< named_hands.h; empty: each operator's own
    std::string mechanism;        ///< kinematics id; empty: the exercise's usual one
    std::vector<std::string> operators{"novice", "intermediate", "expert", "unsafe"};
    /// Where sessions are kept: what is stored there of the same sources and settings is not run again, and
    /// its seeds come first. Null: nowhere.
    LadderStore* store = nullptr;
};

/// What the level's scene says of its forces.
struct LadderLaw {
    bool conservative = false; ///< IScene::conservative()
    bool softens = false;      ///< it states energy by body: the passivity controller answers an excess by
                               ///< rendering the body softer, not by damping
};

/// All sessions of the operators (as many of them as the exercise has) on one level.
struct LadderLevel {
    std::string level; ///< "exercise/number id"
    LadderLaw law;
    std::map<std::string, std::vector<LadderSession>> byOperator;
};

std::string nameOf(const catalogue::ExerciseLevel& level); ///< LadderLevel::level
LadderLaw lawOf(const catalogue::ExerciseLevel& level);
/// Continues what the store has of the level, as far as `seeds`.
LadderLevel climb(const catalogue::ExerciseLevel& level, const LadderSettings& settings);
/// Only what the store has of it.
LadderLevel recalled(const catalogue::ExerciseLevel& level, const LadderSettings& settings);

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

/// What the passivity controller did on the level that its law gives no reason for, one line per session:
/// - a law with a potential is damped. Where a body is rendered softer, which a fast hand on a stiff body
/// brings
///   about with any law, because the controller also keeps an account of samples as late as the device
///   states (docs/testing.md), bodies still hold no more than they were given, but for what the controller
///   allows.
std::vector<std::string> unfounded(const LadderLevel& level);

/// For people: one line per operator.
std::string heading();
std::string lines(const LadderLevel& level);
/// Mean and standard deviation of every metric, one line each, operators as columns; and where the hand was
/// shaken most.
std::string metricLines(const LadderLevel& level);

} // namespace chiron::tests
