// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace chiron::tests {

/// What resists on the bench; all of its damping together is `damping_Ns_per_m`.
enum class BenchLoad {
    viscous,  ///< f = −b v
    friction, ///< f = −F v/√(v² + (F/b)²), F = 2.7 N as in the stricture
    both,     ///< half of each
    canal,    ///< both, along the way; 1120 N/m and b across it (models.md §1.2, the stiffest canal)
    wall,     ///< a wall of 1 kN/m that the hand presses, with contact damping b
};

struct BenchCase {
    std::string mechanism; ///< "five_bar_spherical", "gimbal_hprd" or "fingertip_arm"
    std::string hand;      ///< named_hands.h
    BenchLoad load = BenchLoad::viscous;
    int pose = 0; ///< 0..kBenchPoses − 1
    double damping_Ns_per_m = 0.0;
    /// 0: that of the device's descriptor, which the laws then keep to; else another.
    double budget_Ns_per_m = 0.0;
    std::uint64_t seed = 1;
    double seconds = 12.0;
};

inline constexpr int kBenchPoses = 2;
std::vector<std::string> benchMechanisms();
std::vector<std::string> benchHands();
std::vector<BenchLoad> benchLoads();
std::string nameOf(BenchLoad load);
double budgetOf(const std::string& mechanism); ///< b_max of its descriptor

struct BenchResult {
    double fast_N = 0.0;    ///< FastForce: root mean square above 20 Hz of the worst half second
    double largest_N = 0.0; ///< commanded
    std::uint64_t windows = 0;
    std::uint64_t injected = 0; ///< ticks in which the passivity controller damped
};

/// One hand on one mechanism, through loop and supervisor: it rubs along the way at up to 25 mm/s, rests, and
/// goes on.
BenchResult runBench(const BenchCase& wanted);

} // namespace chiron::tests
