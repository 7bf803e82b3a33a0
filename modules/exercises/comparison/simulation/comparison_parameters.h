// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/attributes/object_attributes.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::simulation {

/// What the objects of a study differ in (P2). Its value is N/m, kg, s, m, 1, N·s/m.
enum class ComparedAttribute : std::uint8_t { stiffness, mass, deformation, roughness, friction, viscosity };

/// Deliberate faults, by which a study shows that it would notice them (psychophysics.md §6). Stored with the session, so that its
/// replay makes the same forces.
enum class ComparisonControl : std::uint8_t {
    none,
    gain,     ///< every force 1.3 times as large
    swapped,  ///< another arrangement than the one that was asked for
    constant, ///< every place has the reference's value
};
inline constexpr double kControlGain = 1.3;

/// Objects side by side that differ in one attribute (P2's studies). What lies where comes with each `present` command: a
/// candidate (row of `values`) and an arrangement (which multiple, 0..2, of the difference lies at each place).
struct ComparisonParameters {
    static constexpr int kMaxPlaces = 3;

    ComparedAttribute attribute = ComparedAttribute::stiffness;
    int places = 3;                                    ///< 1..kMaxPlaces, from left (−x) to right
    std::vector<std::array<double, 3>> values;         ///< [candidate][multiple], SI
    std::vector<std::array<int, kMaxPlaces>> arrangements; ///< multiple at each place; −1 where there is no place
    ObjectAttributes object;                           ///< everything else, the same at all places

    double spacing_m = 0.040;     ///< from one place to the next, along x
    double padRadius_m = 0.009;   ///< of the flat top of a pad
    double padEdge_m = 0.004;     ///< how softly it falls off beyond: e metres out it lies e²/(2·padEdge) lower
    double hookHeight_m = 0.030;  ///< where a tube or an object is taken hold of, above its foot; a tube's rest length
    double hookReach_m = 0.006;   ///< how near the tip has to come to it
    double hookLeave_m = 0.010;   ///< and how far it has to go away to let go, where nothing is stretched

    double exploreLimit_s = 30.0; ///< then the objects go; 0: none
    double answerLimit_s = 20.0;  ///< after that; then the trial ends without an answer; 0: none
    double betweenTrials_s = 1.0;
    bool buttonAnswers = false;   ///< the tool's mark button at a place that is touched answers that place
    bool buttonNeedsAll = false;  ///< and only once every place was touched
    double probeAtLeast_N = 0.0;  ///< a place counts as touched once its object answered with so much; 0: at any touch, as in earlier versions
    bool adjusts = false;         ///< a new `present` in a running trial changes the level
    ComparisonControl control = ComparisonControl::none;
    double maximumForce_N = 4.0;  ///< the exercise's cap for the supervisor
    std::vector<std::string> cues; ///< "object": the places are drawn, all alike
};

/// Arguments of an `answer` command that answer nothing.
inline constexpr std::uint16_t kAnswerSpoiled = 0xFFFF; ///< the trial ends unanswered
inline constexpr std::uint16_t kAnswerFinish = 0xFFFE;  ///< the sitting is over: the session ends as completed

/// Whether the attribute is felt by taking hold of something (a tube, an object) instead of on a pad.
constexpr bool isHooked(ComparedAttribute attribute) noexcept {
    return attribute == ComparedAttribute::stiffness || attribute == ComparedAttribute::mass;
}

/// Where a tip takes hold: a ball over the foot of a place, W.
struct GripZone {
    double height_m = 0.0; ///< of its centre
    double radius_m = 0.0;
};

/// The zone that is drawn, and in all of which a tip takes hold (ComparedObject). An object is taken hold of as near to its ring as
/// `hookReach_m`, all around. A tube only where it is slack, that is below its end: the largest ball that lies in that part. Where neither is
/// taken hold of, a ball of no size.
constexpr GripZone gripZone(const ComparisonParameters& p) noexcept {
    if (!isHooked(p.attribute))
        return {};
    if (p.attribute == ComparedAttribute::mass)
        return {p.hookHeight_m, p.hookReach_m};
    return {p.hookHeight_m - 0.5 * p.hookReach_m, 0.5 * p.hookReach_m};
}

/// x of a place in W (m); y is 0.
constexpr double placeX_m(const ComparisonParameters& p, int place) noexcept {
    return (place - 0.5 * (p.places - 1)) * p.spacing_m;
}

} // namespace chiron::simulation
